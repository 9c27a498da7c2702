from __future__ import annotations

import copy
import multiprocessing
import pickle
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import formicarium
from formicarium import Map, errors

WALLS = np.zeros((4, 6), dtype=bool)
WALLS[1, 2] = True


def small(**rules: Any) -> Map:
    return Map(WALLS, start=(0, 0), goals=(5, 3), **rules)


def test_arrays_are_row_column_and_cells_column_row() -> None:
    made = small()
    assert (made.width, made.height, made.shape) == (6, 4, (4, 6))
    assert np.array_equal(made.blocked, WALLS)
    assert (made.start, made.goals, made.has_ends) == ((0, 0), [(5, 3)], True)
    with pytest.raises(errors.ScenarioError) as refused:
        Map(WALLS, start=(2, 1), goals=(5, 3))
    assert refused.value.kind == "start-blocked"
    assert "(2, 1)" in refused.value.message


@pytest.mark.parametrize("dtype", [bool, np.int8, np.uint8, np.int64, np.uint64, ">i4"])
def test_any_kind_of_0_and_1_in_any_order_is_taken(dtype: Any) -> None:
    cells = WALLS.astype(dtype)
    frozen = cells.copy()
    frozen.flags.writeable = False
    views = [cells, frozen, np.asfortranarray(cells), np.repeat(cells, 2, axis=0)[::2], cells[::-1][::-1], cells.tolist()]
    assert all(Map(view, start=(0, 0), goals=(5, 3)) == small() for view in views)


@pytest.mark.parametrize(
    ("cells", "said"),
    [
        (np.zeros((3, 3)), "float64"),
        (np.zeros((3, 3), dtype=complex), "complex"),
        (np.full((3, 3), "0"), "<U1"),
        (np.full((3, 3), None), "object"),
        (np.array([[0, 1], [0, -1]]), r"blocked\[1, 1\] = -1"),
        (np.array([[0, 2]], dtype=np.uint8), r"blocked\[0, 1\] = 2"),
        (np.zeros(3, dtype=bool), r"shape \(3,\)"),
        (np.zeros((2, 2, 2), dtype=bool), "shape"),
        (np.zeros((0, 3), dtype=bool), "shape"),
        (np.broadcast_to(np.zeros(1, dtype=bool), (10**9, 10**9)), "larger"),
        (np.ma.masked_array(np.zeros((2, 2), dtype=bool), mask=True), "masked"),
        ([[0, 1], [0]], "array"),
        (True, "shape"),
        (None, "cells or heights"),
    ],
)
def test_what_is_no_map_is_refused_by_name(cells: Any, said: str) -> None:
    with pytest.raises(errors.ArgumentError, match=said) as refused:
        Map(cells, start=(0, 0), goals=(1, 0))
    assert isinstance(refused.value, ValueError)
    assert refused.value.hint


def test_a_map_without_free_cells_is_refused() -> None:
    with pytest.raises(errors.FormatError, match="no free cell"):
        Map(np.ones((3, 3), dtype=bool))


def test_ends_that_are_not_named_are_chosen_with_a_warning() -> None:
    with pytest.warns(formicarium.FormicariumWarning) as heard:
        made = Map(WALLS)
    assert [said.message.kind for said in heard] == ["ends-chosen"]  # type: ignore[union-attr]
    assert (made.start, made.goals, made.has_ends) == ((0, 0), [(5, 3)], False)


@pytest.mark.parametrize("end", [(1,), (1, 2, 3), "ab", 7, (0.5, 1), (-1, 0), (2**32, 0), (True, 0), None, [(0, 0), 3]])
def test_what_is_no_cell_is_refused_by_name(end: Any) -> None:
    with pytest.raises(errors.ArgumentError, match="goals" if end is not None else "start"):
        small().replace(**{"start" if end is None else "goals": end})


def test_heights_are_float32_and_nan_is_blocked() -> None:
    heights = np.linspace(0, 9, 24).reshape(4, 6)
    heights[2, 3] = np.nan
    made = Map(heights=heights, start=(0, 0), goals=(5, 3), resolution=2.0, max_slope=60)
    back = made.heights
    assert back is not None
    assert back.dtype == np.float32
    assert np.array_equal(back, heights.astype(np.float32), equal_nan=True)
    assert made.blocked[2, 3]
    assert made.blocked.sum() == 1
    assert small().heights is None
    for wrong in (np.inf, 1e300):
        heights[0, 1] = wrong
        with pytest.raises(errors.ArgumentError, match="no height"):
            Map(heights=heights)
    with pytest.raises(errors.ArgumentError, match="same shape"):
        Map(WALLS, heights=heights[:, 2:])


def test_factors_are_float32_from_1_and_plain_ground_has_none() -> None:
    factors = np.linspace(1, 9, 24).reshape(4, 6)
    made = small(factors=factors)
    back = made.factors
    assert back is not None
    assert back.dtype == np.float32
    assert np.array_equal(back, factors.astype(np.float32))
    assert made.factors is not back
    assert made != small()
    assert pickle.loads(pickle.dumps(made)) == made
    assert made.replace(moves=4).factors is not None
    assert small().factors is None
    assert small(factors=np.ones((4, 6), dtype=int)) == small()
    for wrong in (0.5, np.inf, np.nan, 1e300, 1001):
        factors[0, 1] = wrong
        with pytest.raises(errors.ScenarioError, match=r"\(1, 0\)") as refused:
            small(factors=factors)
        assert refused.value.kind == "factor"
    with pytest.raises(errors.ArgumentError, match="no factors"):
        small(factors=np.full((4, 6), True))
    with pytest.raises(errors.ArgumentError, match="same shape"):
        small(factors=factors[:, 2:])
    with pytest.raises(errors.ScenarioError) as both:
        small(factors=np.full((4, 6), 2), heights=np.zeros((4, 6)))
    assert both.value.kind == "weighted-terrain"


def test_a_robot_needs_room_and_its_map_stays_as_it_was_drawn(tmp_path: Path) -> None:
    inflation = {"radius": 3.0, "cost_scaling": 0.5}
    made = small(robot={"radius": 1.0, "inflation": inflation})
    assert made.robot == {"radius": 1.0, "inflation": {**inflation, "rule": "nav2-smac-2d", "multiplier": 2.0}}
    assert np.array_equal(made.blocked, WALLS)
    assert made.factors is None
    assert pickle.loads(pickle.dumps(made)) == made
    assert made.replace(robot=None) == small()
    run = formicarium.plan(made, "astar")
    assert run.metrics is not None
    assert run.metrics["cost"] > run.metrics["length"]
    made.write(tmp_path / "robot.json")
    assert formicarium.read_map(tmp_path / "robot.json") == made
    with pytest.raises(errors.ScenarioError) as narrow:
        made.replace(start=(2, 0))
    assert narrow.value.kind == "start-too-narrow"


def test_swamp_and_costmaps_are_read_as_costs(tmp_path: Path) -> None:
    (tmp_path / "swamp.map").write_text("type octile\nheight 2\nwidth 3\nmap\n.S.\n...\n", encoding="ascii")
    ends: Any = {"start": (0, 0), "goals": (2, 0)}
    with pytest.warns(formicarium.FormicariumWarning) as read_so:
        swamp = formicarium.read_map(tmp_path / "swamp.map", swamp_factor=3, **ends)
    assert [said.message.kind for said in read_so] == ["swamp-factor"]  # type: ignore[union-attr]
    assert swamp.factors is not None
    assert swamp.factors.tolist() == [[1, 3, 1], [1, 1, 1]]
    with pytest.warns(formicarium.FormicariumWarning) as lost:
        swamp.write(tmp_path / "again.map")
    assert any("no factors" in str(said.message) for said in lost)
    text = "info: {resolution: 1, width: 3, height: 1, origin: {position: {x: 0, y: 0}}}\ndata: [0, 98, 0]\n"
    (tmp_path / "costs.yaml").write_text(text, encoding="ascii")
    asked: list[tuple[Any, float]] = [("nav2-smac-2d", 3.0), ({"rule": "nav2-smac-2d", "multiplier": 4.0}, 5.0)]
    for costs, factor in asked:
        with pytest.warns(formicarium.FormicariumWarning):
            read = formicarium.read_map(tmp_path / "costs.yaml", costs=costs, **ends)
        assert read.factors is not None
        assert read.factors.tolist() == [[1, factor, 1]]


def test_what_comes_out_is_a_copy() -> None:
    made = small()
    made.blocked[:] = True
    made.spec["start"] = [3, 3]
    assert made == small()
    assert made.start == (0, 0)


def test_rules_are_replaced_and_refused_by_name() -> None:
    made = small(moves=4, corner_rule="always", resolution=0.5, world={"x": -1, "y": 2}, name="room")
    assert (made.moves, made.corner_rule, made.resolution, made.name) == (4, "always", 0.5, "room")
    assert made.world == {"x": -1.0, "y": 2.0, "yaw": 0.0, "frame": ""}
    assert made.to_world([(0, 3)]).tolist() == [[-0.75, 2.25]]
    assert made.to_cell(-0.75, 2.25) == (0, 3)
    assert made.replace(world=None).world is None
    assert made.replace(goals=[(1, 0), (5, 3)]).goals == [(1, 0), (5, 3)]
    refusals: list[dict[str, Any]] = [
        {"moves": 5},
        {"corner_rule": "never"},
        {"resolution": 0},
        {"resolution": float("nan")},
        {"world": {"x": 0}},
        {"world": {"x": 0, "y": 0, "z": 0}},
        {"colour": "red"},
        {"slices": True},
        {"goals": []},
        {"goals": [(5, 3), (5, 3)]},
    ]
    for wrong in refusals:
        with pytest.raises(errors.FormicariumError) as refused:
            made.replace(**wrong)
        assert isinstance(refused.value, ValueError), wrong


def test_a_map_is_itself_after_copying_and_in_another_process() -> None:
    hills = formicarium.generate("hills", 12, 9, seed=3)
    for made in (small(moves=4), hills, hills.replace(slices=True)):
        assert pickle.loads(pickle.dumps(made)) == copy.deepcopy(made) == made
    assert small() != small(moves=4)
    with pytest.raises(TypeError, match="unhashable"):
        hash(small())
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.apply(digest, (small(),)) == digest(small())


def digest(made: Map) -> str:
    return formicarium.plan(made, "ant-system", params={"iterations": 3}).digest


def test_maps_are_read_and_written_as_convert_does(tmp_path: Path) -> None:
    made = small()
    made.write(tmp_path / "made.json")
    assert formicarium.read_map(tmp_path / "made.json") == made
    for ending in ("map", "csv", "yaml"):
        path = tmp_path / f"made.{ending}"
        with pytest.warns(formicarium.FormicariumWarning, match="not start"):
            made.write(path)
        with warnings.catch_warnings():
            # That 1 means blocked is told of a table.
            warnings.simplefilter("ignore", formicarium.FormicariumWarning)
            again = formicarium.read_map(path, start=(0, 0), goals=(5, 3))
        assert np.array_equal(again.blocked, WALLS), ending
        assert again.has_ends
    with pytest.warns(formicarium.FormicariumWarning, match="names no goal"):
        formicarium.read_map(tmp_path / "made.map", start=(0, 0))
    ends: dict[str, Any] = {"start": (0, 0), "goals": (1, 2)}
    assert formicarium.read_map(tmp_path / "made.map", crop=(0, 0, 3, 3), **ends).shape == (3, 3)
    with pytest.warns(formicarium.FormicariumWarning):
        assert formicarium.read_map(tmp_path / "made.map", invert=True).blocked.sum() == WALLS.size - 1
    with pytest.raises(errors.ArgumentError, match="ending"):
        made.write(tmp_path / "made.xyz")
    with pytest.raises(errors.FileError, match="cannot write") as refused:
        made.write(tmp_path / "none" / "made.json")
    assert isinstance(refused.value, OSError)
    assert str(pickle.loads(pickle.dumps(refused.value))) == str(refused.value)


def test_what_cannot_be_read_is_refused_as_the_command_line_does(tmp_path: Path) -> None:
    with pytest.raises(errors.FileError, match="No such file"):
        formicarium.read_map(tmp_path / "none.map")
    (tmp_path / "broken.map").write_text("type octile\nheight 2\nwidth 2\nmap\n..\n.x\n", encoding="ascii")
    with pytest.raises(errors.FormatError, match=r"broken\.map: line 6"):
        formicarium.read_map(tmp_path / "broken.map")
    with pytest.raises(errors.ArgumentError, match="invalid type"):
        formicarium.read_map(tmp_path / "broken.map", threshold="dark")
    pieces: list[dict[str, Any]] = [{"crop": (-1, 0, 1, 1)}, {"crop": "abcd"}, {"size": (3,)}, {"size": 3}]
    for piece in pieces:
        with pytest.raises(errors.ArgumentError, match=r"crop|size"):
            formicarium.read_map(tmp_path / "broken.map", **piece)
    with pytest.raises(errors.ArgumentError, match="lattice"):
        formicarium.read_map(tmp_path / "broken.map", lattice={"x0": 1})


def test_a_picture_is_read_with_the_options_of_the_command_line(tmp_path: Path) -> None:
    (tmp_path / "gray.pgm").write_bytes(b"P5 4 2 255\n" + bytes([0, 100, 200, 255, 255, 255, 255, 255]))
    ends: dict[str, Any] = {"start": (3, 0), "goals": (3, 1)}
    with pytest.warns(formicarium.FormicariumWarning, match="darker than 128"):
        assert formicarium.read_map(tmp_path / "gray.pgm", **ends).blocked[0].tolist() == [True, True, False, False]
    with pytest.warns(formicarium.FormicariumWarning, match="darker than 50"):
        dark = formicarium.read_map(tmp_path / "gray.pgm", threshold=50, metres_per_pixel=0.1, **ends)
    assert dark.blocked[0].tolist() == [True, False, False, False]
    assert dark.resolution == 0.1


def test_generators_and_planners_are_the_engines() -> None:
    listed = formicarium.catalog()
    assert {"ant-system", "astar", "custom"} <= {planner["id"] for planner in listed["planners"]}
    for generator in listed["generators"]:
        made = formicarium.generate(generator["id"], 20, 15, seed=2)
        assert (made.shape, made.heights is not None) == ((15, 20), generator["terrain"])
        assert made == formicarium.generate(generator["id"], 20, 15, seed=2)
    with pytest.raises(errors.ArgumentError, match="no generator `swamp`"):
        formicarium.generate("swamp", 3, 3)
    for width, height, density in [(0, 3, None), (5000, 3, None), (3, 3, 2.0), (3, 3, float("nan"))]:
        with pytest.raises(errors.ScenarioError):
            formicarium.generate("random", width, height, density=density)
