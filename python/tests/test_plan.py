from __future__ import annotations

import json
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import formicarium
from formicarium import errors


@pytest.fixture(scope="module")
def blocks() -> formicarium.Map:
    return formicarium.generate("random", 30, 20, seed=7)


def by_command(*arguments: str) -> dict[str, Any]:
    program = [sys.executable, "-m", "formicarium", *arguments, "--format", "json"]
    told: dict[str, Any] = json.loads(subprocess.run(program, capture_output=True, check=True).stdout)
    return told


@pytest.mark.parametrize(
    ("planner", "more", "options"),
    [
        ("ant-system", ["--set", "ants=9", "--seed", "3"], {"params": {"ants": 9}, "seed": 3}),
        ("ant-system", ["--preset", "fire"], {"preset": "fire"}),
        ("astar", ["--moves", "16", "--corner-rule", "always"], {"moves": 16, "corner_rule": "always"}),
        ("theta-star", [], {}),
    ],
)
def test_a_plan_is_the_command_lines(blocks: formicarium.Map, tmp_path: Path, planner: str, more: list[str], options: dict[str, Any]) -> None:
    blocks.write(tmp_path / "blocks.json")
    told = by_command("plan", str(tmp_path / "blocks.json"), "--planner", planner, *more)
    plan = formicarium.plan(blocks, planner, **options)
    assert plan.result == told
    assert plan.path.tolist() == told["path"]
    assert (str(plan.path.dtype), plan.path.ndim, len(plan.digest)) == ("int64", 2, 16)
    assert (plan.length, plan.turns, plan.gap) == (told["length"], told["turns"], told["gap"])
    assert len(plan.history) == len(told["history"])


def test_no_path_is_an_answer() -> None:
    with pytest.warns(formicarium.FormicariumWarning, match="no path leads"):
        closed = formicarium.Map([[0, 1, 0]], start=(0, 0), goals=(2, 0))
    plan = formicarium.plan(closed, "ant-system")
    assert (plan.found, plan.status, plan.length, plan.path.shape) == (False, "no-path", None, (0, 2))
    assert not formicarium.check(closed, plan)["ok"]


@pytest.mark.parametrize(
    ("planner", "options", "kind"),
    [
        ("bee-system", {}, "unknown-planner"),
        ("ant-system", {"preset": "none"}, "unknown-preset"),
        ("ant-system", {"params": {"rho": 7}}, "out-of-range"),
        ("ant-system", {"params": {"rho": float("nan")}}, None),
        ("ant-system", {"params": {"bees": 1}}, "unknown-parameter"),
        ("ant-system", {"seed": -1}, "bad-argument"),
        ("ant-system", {"seed": 2**32}, "bad-argument"),
        ("ant-system", {"threads": -1}, "bad-argument"),
    ],
)
def test_what_cannot_be_planned_is_refused_by_name(blocks: formicarium.Map, planner: str, options: dict[str, Any], kind: str | None) -> None:
    with pytest.raises(errors.FormicariumError) as refused:
        formicarium.plan(blocks, planner, **options)
    assert isinstance(refused.value, ValueError)
    assert refused.value.hint
    assert kind is None or refused.value.kind == kind


def test_what_is_no_map_or_value_is_a_clear_error(blocks: formicarium.Map) -> None:
    with pytest.raises(errors.ArgumentError, match="ndarray is no map"):
        formicarium.plan(blocks.blocked, "astar")  # type: ignore[arg-type]
    with pytest.raises(errors.ArgumentError, match="NoneType is no map"):
        formicarium.check(None, [])  # type: ignore[arg-type]
    with pytest.raises(errors.ArgumentError, match="rho"):
        formicarium.plan(blocks, "ant-system", params={"rho": [1]})


def test_scalars_of_numpy_are_values(blocks: formicarium.Map) -> None:
    given = {"ants": np.int64(9), "rho": np.float32(0.5), "iterations": np.uint8(5)}
    plain = {"ants": 9, "rho": 0.5, "iterations": 5}
    assert formicarium.plan(blocks, "ant-system", params=given).digest == formicarium.plan(blocks, "ant-system", params=plain).digest


def test_threads_change_nothing(blocks: formicarium.Map) -> None:
    digests = {formicarium.plan(blocks, "ant-system", params={"iterations": 10}, threads=threads).digest for threads in (0, 1, 2)}
    with ThreadPoolExecutor(4) as pool:
        digests |= {plan.digest for plan in pool.map(lambda _: formicarium.plan(blocks, "ant-system", params={"iterations": 10}), range(8))}
    assert len(digests) == 1


def test_a_plan_is_itself_after_pickling(blocks: formicarium.Map) -> None:
    plan = formicarium.plan(blocks, "astar")
    again = pickle.loads(pickle.dumps(plan))
    assert again.result == plan.result
    assert np.array_equal(again.path, plan.path)


def test_other_threads_go_on_meanwhile(blocks: formicarium.Map) -> None:
    begun = threading.Event()
    plans: list[formicarium.Plan] = []

    def work() -> None:
        begun.set()
        plans.append(formicarium.plan(blocks, "ant-system", params={"iterations": 300, "ants": 100}))

    worker, turns = threading.Thread(target=work), 0
    worker.start()
    begun.wait()
    while worker.is_alive():
        turns += 1
        time.sleep(0.001)
    # Had the engine kept Python to itself, there would have been a turn or two.
    assert turns > 20
    assert plans[0].iterations == 300


def test_ctrl_c_ends_a_long_plan() -> None:
    code = (
        # What starts the tests may have it ignored.
        "import signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "import formicarium\n"
        "field = formicarium.generate('random', 300, 300)\n"
        "print('begun', flush=True)\n"
        "try:\n    formicarium.plan(field, 'ant-system', params={'iterations': 100000})\n"
        "except KeyboardInterrupt:\n    print('heeded')\n"
    )
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "begun\n"
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        assert child.stdout.read() == "heeded\n"


def test_check_tells_what_the_command_line_tells(blocks: formicarium.Map, tmp_path: Path) -> None:
    blocks.write(tmp_path / "blocks.json")
    plan = formicarium.plan(blocks, "astar")
    spoilt = plan.path.copy()
    spoilt[3] = (29, 0)
    for path in (plan.path, spoilt, plan.path[1:], np.array([[99, 99]])):
        (tmp_path / "path.json").write_text(json.dumps(path.tolist()), encoding="ascii")
        program = [sys.executable, "-m", "formicarium", "check", str(tmp_path / "path.json"), "--map", str(tmp_path / "blocks.json")]
        told = json.loads(subprocess.run([*program, "--format", "json"], capture_output=True).stdout)
        assert formicarium.check(blocks, path) == told
    assert formicarium.check(blocks, plan)["ok"]
    assert formicarium.check(blocks, formicarium.plan(blocks, "any-angle"))["kind"] == "polyline"
    assert not formicarium.check(blocks, [])["ok"]


@pytest.mark.parametrize("path", [[[0.5, 1.0]], [[-1, 0]], [[1, 2, 3, 4]], "path", [[1], [1, 2]], np.array([[2**63]], dtype=np.uint64)])
def test_what_is_no_path_is_refused(blocks: formicarium.Map, path: Any) -> None:
    with pytest.raises(errors.ArgumentError, match="path"):
        formicarium.check(blocks, path)


def test_by_slices_a_place_has_a_level() -> None:
    hills = formicarium.generate("hills", 21, 21, seed=3).replace(slices=True, start=(0, 10), goals=(20, 8))
    plan = formicarium.plan(hills, "slices-exact")
    assert plan.levels is not None
    assert plan.altitudes is not None
    assert len(plan.levels) == len(plan.path) == len(plan.altitudes)
    assert formicarium.check(hills, plan)["ok"]
    assert formicarium.check(hills, np.column_stack([plan.path, plan.levels]))["ok"]
    with pytest.raises(errors.ArgumentError, match="no levels"):
        formicarium.check(hills, plan.path)


def test_metres_come_out_where_the_map_has_a_place() -> None:
    field = formicarium.Map(np.zeros((3, 4), dtype=bool), start=(0, 0), goals=(3, 0), resolution=0.5, world={"x": 10, "y": 20})
    plan = formicarium.plan(field, "astar")
    assert (plan.length, plan.length_metres) == (3.0, 1.5)
    assert plan.path_world is not None
    assert plan.path_world[0].tolist() == [10.25, 21.25]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_a_fork_plans_the_same() -> None:
    code = (
        "import os, sys, formicarium\n"
        "field = formicarium.generate('random', 30, 20)\n"
        "asked = {'seeds': 2, 'instances': [{'id': 'a', 'map': field}], 'entries': [{'id': 'ants', 'planner': 'ant-system'}]}\n"
        "first = formicarium.compare(asked).document()\n"
        "child = os.fork()\n"
        "same = formicarium.compare(asked).document() == first\n"
        "if child == 0:\n    os._exit(0 if same else 1)\n"
        "sys.exit(0 if same and os.waitpid(child, 0)[1] == 0 else 1)\n"
    )
    assert subprocess.run([sys.executable, "-c", code], timeout=60).returncode == 0
