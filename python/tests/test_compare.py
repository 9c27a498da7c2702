from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

import formicarium
from formicarium import errors


@pytest.fixture(scope="module")
def written(question: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The files that the command line writes for the question."""
    out = tmp_path_factory.mktemp("out")
    kinds = "csv,markdown,tests,tests-csv,summary-csv,summary-json,latex,claims-csv,matrix-csv,json"
    assert formicarium.command(["compare", question, "--out", out, "--files", kinds]) == 0
    return out


def test_every_file_has_the_bytes_of_the_command_line(compared: formicarium.Comparison, written: Path) -> None:
    kinds = ["csv", "markdown", "tests", "tests-csv", "summary-csv", "summary-json", "latex", "claims-csv", "matrix-csv", "json"]
    endings = dict(formicarium._engine.Comparison.kinds())
    for kind in kinds:
        assert compared.file(kind).encode() == (written / f"small.{endings[kind]}").read_bytes(), kind
    assert compared.document() == compared.file("json")
    assert compared.markdown("zh-CN") != compared.markdown()


def test_question_seeds_budget_and_instances_are_narrowed_alike(question: Path, tmp_path: Path) -> None:
    options = ["--seeds", "2", "--budget", "constructed-paths=40", "--only", "blocks"]
    assert formicarium.command(["compare", question, "--out", tmp_path, *options]) == 0
    with pytest.warns(formicarium.FormicariumWarning):
        narrowed = formicarium.compare(question, seeds=2, budget=("constructed-paths", 40), only="blocks", jobs=1)
    assert narrowed.file("markdown").encode() == (tmp_path / "small.md").read_bytes()


def test_rows_are_a_table_with_the_columns_of_the_csv(compared: formicarium.Comparison) -> None:
    pytest.importorskip("pyarrow")
    rows = compared.rows
    assert rows.num_rows == 60
    assert ",".join(rows.column_names) == compared.file("csv").partition("\n")[0]
    assert {str(rows.schema.field(name).type) for name in ("length", "gap", "weight")} == {"double"}
    assert str(rows.schema.field("seed").type) == "int64"
    assert rows.to_pylist() == compared.records()
    best = {(row["entry"], row["seed"]): row["value"] for row in rows.to_pylist()}
    last = {(step["entry"], step["seed"]): step["value"] for step in compared.traces.to_pylist()}
    assert best == pytest.approx(last, abs=1e-6)
    assert compared.tests.num_rows > 0


def test_traces_are_every_improvement(compared: formicarium.Comparison) -> None:
    pytest.importorskip("pyarrow")
    document = json.loads(compared.document())
    told = [(row["task"]["seed"], *improvement) for row in document["rows"] for improvement in row["trace"]]
    names = ("seed", "value", "iterations", "constructed_paths", "ant_moves", "cell_expansions")
    assert [tuple(step[name] for name in names) for step in compared.traces.to_pylist()] == told


def test_verdicts_and_summary_are_data(compared: formicarium.Comparison) -> None:
    assert [verdict["claim"] for verdict in compared.verdicts] == ["shorter"]
    assert compared.summary["format"].startswith("formicarium/summary@")
    assert "Ants on a small map" in repr(compared)


def test_a_question_of_a_dict_is_that_of_its_document(asked: dict[str, Any], tmp_path: Path) -> None:
    from_dict = formicarium.compare(asked)
    [path] = from_dict.write(tmp_path / "new", "mine", ["json"])
    assert formicarium.compare(path).document() == from_dict.document()
    assert formicarium.command(["compare", path, "--out", tmp_path]) == 0
    assert (tmp_path / "mine.csv").read_text() == from_dict.file("csv")
    assert len(formicarium.compare(asked, seeds=2).records()) == 4


def test_progress_is_told_on_the_calling_thread(asked: dict[str, Any]) -> None:
    told: list[tuple[int, int]] = []
    formicarium.compare(asked, progress=lambda done, of: told.append((done, of)))
    assert told[-1] == (6, 6)
    assert told == sorted(told)

    def stop(done: int, of: int) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        formicarium.compare(asked, progress=stop)


def test_what_cannot_be_asked_is_refused_by_name(asked: dict[str, Any], question: Path) -> None:
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"entries": [{"id": "ants", "planner": "bee-system"}]}, "bee-system"),
        ({"entries": [{"id": "Ants!", "planner": "astar"}]}, "Ants!"),
        ({"entries": "ants"}, "list of dicts"),
        ({"instances": []}, "instances"),
        ({"instances": [{"id": "a", "map": 7}]}, "the map of instance 'a' is int"),
        ({"instances": [{"id": "a", "map": "none.map"}]}, "No such file"),
        ({"seeds": 0}, "seeds"),
        ({"colour": "red"}, "colour"),
        ({"entries": [{"id": "a", "planner": "ant-system", "set": {"rho": float("nan")}}]}, "finite"),
        ({"entries": [{"id": "a", "planner": "ant-system", "set": {"rho": object()}}]}, "no plain data"),
        ({"entries": [{"id": "a", "results": "mine.csv"}]}, "results from elsewhere"),
    ]
    for change, said in wrong:
        with pytest.raises(errors.FormicariumError, match=said):
            formicarium.compare({**asked, **change})
    for options in ({"budget": "time=3"}, {"budget": 5}, {"budget": ("moves",)}, {"only": ["none"]}, {"jobs": 0}, {"seeds": 0}):
        with pytest.raises(errors.FormicariumError):
            formicarium.compare(asked, **options)
    with pytest.raises(errors.FileError, match="No such file"):
        formicarium.compare("none.toml")
    with pytest.raises(errors.ArgumentError, match="invalid value"):
        formicarium.compare(question, budget="time=3")


def test_ctrl_c_ends_a_comparison_between_its_runs() -> None:
    code = (
        # What starts the tests may have it ignored.
        "import signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "import formicarium\n"
        "field = formicarium.generate('random', 60, 60)\n"
        "asked = {'seeds': 1000, 'instances': [{'id': 'a', 'map': field}], 'entries': [{'id': 'ants', 'planner': 'ant-system'}]}\n"
        "print('begun', flush=True)\n"
        "try:\n    formicarium.compare(asked)\n"
        "except KeyboardInterrupt:\n    print('heeded')\n"
    )
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "begun\n"
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        assert child.stdout.read() == "heeded\n"
