"""Maps: from arrays, from files, made by seed."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypedDict

import numpy as np
import numpy.typing as npt

from . import _engine
from ._cells import blocked_bytes, cell, cells, factor_bytes, height_bytes, whole
from ._need import bad, warn, warn_of_lines

if TYPE_CHECKING:
    from typing_extensions import Unpack

#: Notices about a scenario that are told anew when it is changed.
ABOUT_THE_WAY = frozenset({"start-is-goal", "unreachable"})

#: A cell as (column, row), counted from 0 at the upper left.
Cell = tuple[int, int]


class Rules(TypedDict, total=False):
    """How one moves on a map, and where it lies: what ``Map``, ``Map.replace`` and ``read_map`` take by name."""

    #: 4, 8 or 16.
    moves: int
    #: ``always``, ``one-free`` or ``both-free``: cells that must be free beside a diagonal step.
    corner_rule: str
    #: Metres a cell.
    resolution: float
    #: The place of the lower left corner: ``x``, ``y`` in metres, ``yaw`` in radians, ``frame``; None: not known.
    world: Mapping[str, Any] | None
    #: Metres per unit of the heights.
    vertical_unit: float
    #: Steepest ground in degrees, on the surface of a terrain.
    max_slope: float
    #: True: rules by slices that suit the terrain; a dict: these rules; None: on the surface.
    slices: bool | Mapping[str, Any] | None
    #: Metres per second, for the travel time.
    speed: float
    #: Seconds lost at each turn, for the travel time.
    seconds_per_turn: float
    #: The robot: ``radius`` in metres, ``inflation`` with ``radius``, ``cost_scaling``, ``rule``, ``multiplier``; None: a point.
    robot: Mapping[str, Any] | None


class Changes(Rules, total=False):
    """The same, and what is asked on the map."""

    #: A cell.
    start: npt.ArrayLike
    #: A cell, or several.
    goals: npt.ArrayLike
    #: Its name in tables.
    name: str


class Map:
    """A map with the question asked on it: start, goals, how one moves. It never changes; ``replace`` gives another one.

    A cell is ``(column, row)``, counted from 0 at the upper left. Arrays are ``[row, column]``: the cell ``(3, 12)`` is ``blocked[12, 3]``.

    ``blocked``: array of bool, or of 0 (free) and 1 (blocked). It may be None where there are heights.
    ``heights``: array of float32, NaN = no data (blocked); the map is then a terrain.
    ``factors``: array of float32 from 1, how many times its length a way through a cell costs; the ground is then weighted. Not with heights.
    ``start``, ``goals``: cells. Left out, the free cells nearest the upper left and the lower right corner are taken, with a warning.
    ``moves``: 4, 8 or 16; ``corner_rule``: ``always``, ``one-free`` or ``both-free``.
    ``resolution``: metres a cell. ``world``: the place of the lower left corner, ``{"x": m, "y": m, "yaw": radians, "frame": name}``.
    ``vertical_unit``: metres per unit of the heights; ``max_slope`` in degrees; ``slices``: True, or rules by slices as a dict.
    ``robot``: ``{"radius": m}``, and with ``"inflation": {"radius": m, "cost_scaling": 1/m}`` cells near obstacles cost more, as Nav2 counts.
    """

    __slots__ = ("_native", "_spec")
    _native: _engine.Map
    _spec: dict[str, Any]

    def __init__(
        self,
        blocked: npt.ArrayLike | None = None,
        *,
        heights: npt.ArrayLike | None = None,
        factors: npt.ArrayLike | None = None,
        start: npt.ArrayLike | None = None,
        goals: npt.ArrayLike | None = None,
        name: str = "",
        **rules: Unpack[Rules],
    ) -> None:
        if blocked is None and heights is None:
            raise bad("blocked", "a map needs cells or heights", "give an array [row, column]")
        size, raised = height_bytes(heights) if heights is not None else ((0, 0), None)
        of_cells, walls = blocked_bytes(blocked) if blocked is not None else (size, bytes(size[0] * size[1]))
        if raised is not None and of_cells != size:
            message = f"{size[1]} rows and {size[0]} columns of heights on {of_cells[1]} rows and {of_cells[0]} columns of cells"
            raise bad("heights", message, "give two arrays of the same shape")
        of_factors, weighed = factor_bytes(factors) if factors is not None else (of_cells, None)
        if of_factors != of_cells:
            message = f"{of_factors[1]} rows and {of_factors[0]} columns of factors on {of_cells[1]} rows and {of_cells[0]} columns of cells"
            raise bad("factors", message, "give two arrays of the same shape")
        first = None if start is None else cell(start, "start")
        last = None if goals is None else cells(goals, "goals")
        native, notices = _engine.Map.of_cells(of_cells, walls, raised, weighed, name, (first, last[0] if last else None))
        self._adopt(native)
        changes: dict[str, Any] = dict(rules) if last is None else {"goals": last, **rules}
        if first is not None:
            changes["start"] = first
        if changes:
            given = first is not None and last is not None
            self._adopt(self._changed(changes, native.has_ends or given)[0])
        warn(notices)

    def _adopt(self, native: _engine.Map) -> None:
        self._native = native
        self._spec = json.loads(native.spec)

    @classmethod
    def _of(cls, native: _engine.Map) -> Map:
        made = cls.__new__(cls)
        made._adopt(native)
        return made

    def _changed(self, changes: Mapping[str, Any], has_ends: bool) -> tuple[_engine.Map, list[tuple[str, str]]]:
        spec = _edited(self._native, self._spec, changes)
        return self._native.with_spec(_json(spec, "map"), has_ends)

    def replace(self, **changes: Unpack[Changes]) -> Map:
        """The same cells with other ``start``, ``goals``, ``moves``, ``corner_rule``, ``resolution``, ``world``, ``name``, ``vertical_unit``,
        ``max_slope``, ``slices``, ``speed``, ``seconds_per_turn`` or ``robot``.

        Raises ``ScenarioError`` for what cannot be, e.g. a start on a wall.
        """
        has_ends = self._native.has_ends or {"start", "goals"} <= changes.keys()
        native, notices = self._changed(changes, has_ends)
        warn(notices)
        return Map._of(native)

    @property
    def blocked(self) -> npt.NDArray[np.bool_]:
        """Whether each cell is blocked, [row, column]; a copy."""
        cells: npt.NDArray[np.bool_] = np.frombuffer(self._native.cells(), dtype=np.bool_)
        copied: npt.NDArray[np.bool_] = cells.reshape(self.shape).copy()
        return copied

    @property
    def heights(self) -> npt.NDArray[np.float32] | None:
        """The height of each cell in the map's vertical unit, [row, column], NaN = no data; a copy. None on a plane."""
        heights = self._native.heights()
        if heights is None:
            return None
        return np.frombuffer(heights, dtype="<f4").astype(np.float32).reshape(self.shape)

    @property
    def factors(self) -> npt.NDArray[np.float32] | None:
        """How many times its length a way through each cell costs, [row, column]; a copy. None on plain ground, where all are 1."""
        factors = self._native.factors()
        if factors is None:
            return None
        return np.frombuffer(factors, dtype="<f4").astype(np.float32).reshape(self.shape)

    @property
    def robot(self) -> dict[str, Any] | None:
        """The robot: ``radius`` in metres, and ``inflation`` where cells near obstacles cost more. None: a point."""
        robot = self.spec.get("robot")
        return None if robot is None else dict(robot)

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns, as arrays have them."""
        columns, rows = self._native.size
        return rows, columns

    @property
    def width(self) -> int:
        """Columns."""
        return self._native.size[0]

    @property
    def height(self) -> int:
        """Rows."""
        return self._native.size[1]

    @property
    def name(self) -> str:
        """Its name in tables; may be empty."""
        return str(self._spec["name"])

    @property
    def start(self) -> Cell:
        """The start as (column, row)."""
        x, y = self._spec["start"]
        return x, y

    @property
    def goals(self) -> list[Cell]:
        """The goals, each as (column, row)."""
        return [(goal["at"][0], goal["at"][1]) for goal in self._spec["goals"]]

    @property
    def moves(self) -> int:
        """Moves that a cell offers: 4, 8 or 16."""
        return int(self._spec["movement"]["moves"])

    @property
    def corner_rule(self) -> str:
        """Cells that must be free beside a diagonal step: ``always`` (none), ``one-free``, ``both-free``."""
        return str(self._spec["movement"]["corner_rule"])

    @property
    def resolution(self) -> float:
        """Metres a cell."""
        return float(self._spec["resolution"])

    @property
    def world(self) -> dict[str, Any] | None:
        """Where the lower left corner lies: ``x``, ``y`` in metres, ``yaw`` in radians, ``frame``. None where that is not known."""
        world = self._spec.get("world")
        return None if world is None else dict(world)

    @property
    def has_ends(self) -> bool:
        """Whether start and goals were named; otherwise they were chosen."""
        return self._native.has_ends

    @property
    def spec(self) -> dict[str, Any]:
        """Every field of the scenario but its cells, as docs/schema/scenario.schema.json has them; a copy."""
        fields: dict[str, Any] = json.loads(self._native.spec)
        return fields

    def to_world(self, path: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """The middles of cells (column, row) in metres of the world, as (x, y). Raises ``ArgumentError`` where the map's place is not known."""
        given = cells(path, "path")
        places = [self._native.to_world(at) for at in given]
        known = [place for place in places if place is not None]
        if len(known) < len(given):
            raise bad("world", "the map does not say where it lies in the world", "give it a `world`")
        return np.array(known, dtype=np.float64).reshape(len(given), 2)

    def to_cell(self, x: float, y: float) -> Cell | None:
        """The cell (column, row) at a place in metres; None beside the map, or where its place is not known."""
        return self._native.to_cell((x, y))

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes it in the format that the ending tells, as ``formicarium convert`` does; warns of what that format does not hold."""
        warn_of_lines(self._native.write(os.fspath(path)))

    def __repr__(self) -> str:
        name = f"{self.name!r}, " if self.name else ""
        ends = " and ".join(str(goal) for goal in self.goals[:3]) + (" …" if len(self.goals) > 3 else "")
        return f"<formicarium.Map {name}{self.height} rows × {self.width} columns, {self.start} → {ends}>"

    def __eq__(self, other: object) -> bool:
        return self._native.same_as(other._native) if isinstance(other, Map) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        native = self._native
        return _unpickled, (native.size, native.cells(), native.heights(), native.spec, native.has_ends, native.factors())


def _unpickled(size: tuple[int, int], walls: bytes, heights: bytes | None, spec: str, has_ends: bool, factors: bytes | None = None) -> Map:
    return Map._of(_engine.Map.of_parts(size, walls, heights, factors, spec, has_ends))


def _json(value: Any, field: str) -> str:
    """Plain data as JSON; scalars and arrays of NumPy are taken for theirs."""

    def plain(one: Any) -> Any:
        if isinstance(one, (np.generic, np.ndarray)):
            return one.tolist()
        raise bad(field, f"{one!r} is no plain data", "give numbers, texts, lists and dicts")

    try:
        return json.dumps(value, default=plain, allow_nan=False)
    except ValueError as error:
        raise bad(field, f"it holds what JSON does not: {error}", "give finite numbers") from None


def _edited(native: _engine.Map, spec: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """The fields of a scenario with some of them changed."""
    fields: dict[str, Any] = json.loads(json.dumps(spec))
    for key, value in changes.items():
        if key == "start":
            fields["start"] = cell(value, "start")
        elif key == "goals":
            fields["goals"] = _goals(fields["goals"], cells(value, "goals"))
        elif key == "moves":
            fields["movement"]["moves"] = whole(value, "moves")
        elif key == "corner_rule":
            fields["movement"]["corner_rule"] = value
        elif key in ("speed", "seconds_per_turn"):
            fields["vehicle"][key] = value
        elif key in ("vertical_unit", "max_slope", "slices"):
            _edit_terrain(fields, key, value)
        elif key in ("name", "resolution", "world", "robot"):
            fields[key] = value
        else:
            known = "start, goals, moves, corner_rule, resolution, world, name, vertical_unit, max_slope, slices, speed, seconds_per_turn, robot"
            raise bad(key, f"a map has no field `{key}`", f"give {known}")
    if changes.get("slices") is True:
        on_the_ground = {"vertical_unit": fields["terrain"]["vertical_unit"]}
        fitting, _ = native.with_spec(_json({**fields, "terrain": on_the_ground}, "map"), True)
        fields["terrain"]["slices"] = json.loads(fitting.fitting_slices())
    for absent in [key for key in ("world", "robot") if fields.get(key) is None]:
        fields.pop(absent, None)
    return fields


def _edit_terrain(fields: dict[str, Any], key: str, value: Any) -> None:
    terrain = fields.get("terrain")
    if terrain is None:
        raise bad(key, f"{key} is for terrains, and the map has no heights", "give heights")
    if key == "slices":
        terrain.pop("max_slope", None)
        terrain.pop("slices", None)
        if value is not None and value is not False:
            terrain["slices"] = value
    elif key == "max_slope" and "slices" in terrain:
        raise bad(key, "max_slope says nothing about moving by slices", "give slices=None with it, or leave it out")
    else:
        terrain[key] = value


def _goals(before: Sequence[Mapping[str, Any]], at: Sequence[Cell]) -> list[dict[str, Any]]:
    """As many goals as there are keep their names and weights; another number takes their place."""
    if len(before) == len(at):
        return [{**goal, "at": place} for goal, place in zip(before, at)]
    return [{"at": place} for place in at]


def read_map(
    path: str | os.PathLike[str],
    *,
    start: npt.ArrayLike | None = None,
    goals: npt.ArrayLike | None = None,
    crop: tuple[int, int, int, int] | None = None,
    size: tuple[int, int] | None = None,
    square: bool = False,
    invert: bool = False,
    matrix: int | None = None,
    threshold: int | str | None = None,
    light_is_blocked: bool = False,
    cells: int | None = None,
    metres_per_pixel: float | None = None,
    metres_per_cell: float | None = None,
    unknown: str | None = None,
    costs: str | Mapping[str, Any] | None = None,
    swamp_factor: float | None = None,
    figure: bool = False,
    lattice: Mapping[str, float] | None = None,
    **rules: Unpack[Rules],
) -> Map:
    """Reads a map of any format that the engine knows; the options are those of ``formicarium convert``.

    ``invert``: swap free and blocked cells. ``crop``: (column, row, columns, rows); ``size``: (columns, rows);
    ``threshold``: gray from 0 to 255, or ``"auto"``;
    ``unknown``: ``"blocked"`` or ``"free"`` cells of ROS maps; ``costs``: their values are those of a costmap, by the rule ``"nav2-smac-2d"`` or
    ``"nav2-navfn"``, or ``{"rule": …, "multiplier": …}``; ``swamp_factor``: of swamp in MovingAI maps;
    ``lattice``: ``{"x0", "y0", "dx", "dy", "shear_x", "shear_y", "columns", "rows"}``.
    ``rules`` are the fields of ``Map.replace``. What was assumed is a ``FormicariumWarning``; what cannot be read a ``FormatError``.
    """
    piece = (None if crop is None else _wholes(crop, "crop", 4), None if size is None else _wholes(size, "size", 2), square)
    picture: dict[str, Any] = {"light_is_blocked": light_is_blocked, "cells": cells}
    picture.update(metres_per_pixel=metres_per_pixel, metres_per_cell=metres_per_cell)
    if threshold is not None:
        picture["threshold"] = None if threshold == "auto" else threshold
    options: dict[str, Any] = {"matrix": matrix, "cells": cells, "picture": picture}
    if unknown is not None:
        options["unknown"] = unknown
    if costs is not None:
        options["costs"] = {"rule": costs} if isinstance(costs, str) else costs
    if swamp_factor is not None:
        options["swamp_factor"] = swamp_factor
    if figure:
        options["figure"] = {"lattice": None if lattice is None else {"shear_x": 0.0, "shear_y": 0.0, **lattice}}
    elif lattice is not None:
        raise bad("lattice", "a lattice is of a figure", "add figure=True")
    given = (start is not None, goals is not None)
    native, notices = _engine.read_map(os.fspath(path), _json(options, "options"), piece, invert, given)
    ends: dict[str, Any] = {key: value for key, value in (("start", start), ("goals", goals)) if value is not None}
    changes = {**ends, **rules}
    read = Map._of(native)
    if changes:
        changed, more = read._changed(changes, native.has_ends)
        read = Map._of(changed)
        notices = [notice for notice in notices if notice[0] not in ABOUT_THE_WAY] + more
    warn(notices)
    return read


def _wholes(value: Any, field: str, count: int) -> Any:
    """So many whole numbers."""
    given = tuple(value) if isinstance(value, (Iterable, np.ndarray)) else ()
    if len(given) != count:
        raise bad(field, f"{field} = {value!r} cannot be used", f"give {count} whole numbers")
    return tuple(whole(one, field) for one in given)


def generate(kind: str, width: int, height: int, *, seed: int = 1, density: float | None = None) -> Map:
    """A made-up map of ``width`` columns and ``height`` rows; the same seed gives the same map on every machine.

    ``catalog()["generators"]`` lists the kinds. ``density``: share of obstacles, or roughness of a terrain, where the kind asks for one.
    """
    return Map._of(_engine.generate(kind, (whole(width, "width"), whole(height, "height")), whole(seed, "seed"), density))


def catalog() -> dict[str, Any]:
    """The planners with their presets and parameters, the generators and the limits: what ``formicarium catalog --json`` prints."""
    listed: dict[str, Any] = json.loads(_engine.catalog())
    return listed
