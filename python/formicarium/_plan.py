"""One run of a planner, and the audit of a path."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _engine
from ._cells import whole
from ._map import Map
from ._need import bad


@dataclass(frozen=True, eq=False)
class Plan:
    """What a run has come to: the fields of ``formicarium plan --format json``, with the path as an array.

    Lengths are in cells, except those that say metres. Without a path ``path`` has no rows, and measures are None.
    """

    #: Everything that the engine tells: docs/schema/result.schema.json.
    result: Mapping[str, Any]
    #: The path: one row a place, (column, row).
    path: npt.NDArray[np.int64]
    #: By slices the level of each place, else None.
    levels: npt.NDArray[np.int64] | None
    #: On a terrain the altitude of each place in metres, else None.
    altitudes: npt.NDArray[np.float64] | None
    #: The path in metres of the world, (x, y), where the map says where it lies, else None.
    path_world: npt.NDArray[np.float64] | None

    @property
    def found(self) -> bool:
        """Whether there is a path."""
        return self.result["metrics"] is not None

    @property
    def status(self) -> str:
        """How the run ended: optimal, complete, stagnated, budget-spent, no-path."""
        return str(self.result["status"])

    @property
    def digest(self) -> str:
        """16 hexadecimal digits over the run: equal inputs and seed give equal ones on every machine."""
        return str(self.result["digest"])

    @property
    def metrics(self) -> Mapping[str, Any] | None:
        """Every measure of the path: length, turns, clearance and what else the engine tells."""
        metrics: Mapping[str, Any] | None = self.result["metrics"]
        return metrics

    def _metric(self, name: str) -> Any:
        return None if self.metrics is None else self.metrics[name]

    @property
    def length(self) -> float | None:
        """Length in cells."""
        return _real(self._metric("length"))

    @property
    def length_metres(self) -> float | None:
        """Length in metres: of a map without a scale a cell is 1 m."""
        return _real(self._metric("length_metres"))

    @property
    def turns(self) -> int | None:
        """Number of turns."""
        turns: int | None = self._metric("turns")
        return turns

    @property
    def min_clearance(self) -> float | None:
        """Smallest distance to an obstacle in cells, from centre to centre."""
        return _real(self._metric("min_clearance"))

    @property
    def mean_clearance(self) -> float | None:
        """Mean distance to the nearest obstacle in cells, from centre to centre."""
        return _real(self._metric("mean_clearance"))

    @property
    def value(self) -> float | None:
        """The result by the planner's own objective."""
        return _real(self.result["value"])

    @property
    def gap(self) -> float | None:
        """How far the value lies above the best known, as a part of it."""
        return _real(self.result["gap"])

    @property
    def effort(self) -> Mapping[str, int]:
        """Iterations, constructed paths, ant moves and cell expansions."""
        effort: Mapping[str, int] = self.result["effort"]
        return effort

    @property
    def iterations(self) -> int:
        """Finished iterations."""
        return int(self.effort["iterations"])

    @property
    def history(self) -> npt.NDArray[np.float64]:
        """The best length in cells after each iteration; NaN before the first path."""
        best = [record["best_so_far"] for record in self.result["history"]]
        return np.array([np.nan if length is None else length for length in best], dtype=np.float64)

    def __repr__(self) -> str:
        length = "no path" if self.length is None else f"length {self.length:.4f}"
        return f"<formicarium.Plan {self.result['planner']}, seed {self.result['seed']}: {length}, {self.status}, {self.digest}>"


def _real(value: Any) -> float | None:
    return None if value is None else float(value)


def plan(
    map: Map,
    planner: str,
    *,
    seed: int = 1,
    preset: str | None = None,
    params: Mapping[str, Any] | None = None,
    moves: int | None = None,
    corner_rule: str | None = None,
    threads: int = 1,
) -> Plan:
    """Runs a planner on a map. ``catalog()["planners"]`` lists them with their presets and parameters.

    ``params``: values over preset and default. ``threads``: on which the ants of an iteration walk, 0 for all cores; the result is the same.
    Other Python threads go on meanwhile, and Ctrl-C ends it. That there is no path is an answer: ``Plan.found`` is False.
    """
    _check_map(map)
    changes: dict[str, Any] = {key: value for key, value in (("moves", moves), ("corner_rule", corner_rule)) if value is not None}
    asked = map.replace(**changes) if changes else map
    threads = whole(threads, "threads", most=1024)
    told = _engine.plan(asked._native, planner, whole(seed, "seed"), preset, dict(params or {}), threads)
    result: dict[str, Any] = json.loads(told)
    path = np.array(result["path"], dtype=np.int64).reshape(-1, 2)
    levels, altitudes = result.get("levels"), result.get("altitudes")
    return Plan(
        result=result,
        path=path,
        levels=None if levels is None else np.array(levels, dtype=np.int64),
        altitudes=None if altitudes is None else np.array(altitudes, dtype=np.float64),
        path_world=None if asked.world is None else asked.to_world(path),
    )


def check(map: Map, path: Plan | npt.ArrayLike, *, polyline: bool | None = None) -> dict[str, Any]:
    """Audits a path: the fields of ``formicarium check --format json``. ``["ok"]`` tells whether nothing is wrong.

    ``path``: a Plan, or an array with a row (column, row) for each place, by slices (column, row, level). ``polyline``: its points are joined by
    straight segments, not by steps; of a Plan that is known. The ends count where the map names them (``Map.has_ends``).
    """
    _check_map(map)
    levels: list[int] | None = None
    if isinstance(path, Plan):
        if polyline is None:
            polyline = path.result["objective"] == "polyline-length"
        levels = None if path.levels is None else path.levels.tolist()
        places = path.path
    else:
        places = _places(path)
    if places.shape[1] == 3:
        levels = [int(level) for level in places[:, 2]]
    points = [(int(x), int(y)) for x, y in places[:, :2]]
    findings: dict[str, Any] = json.loads(_engine.check(map._native, points, levels, bool(polyline)))
    return findings


def _check_map(map: Any) -> None:
    if not isinstance(map, Map):
        raise bad("map", f"{type(map).__name__} is no map", "give a formicarium.Map, e.g. Map(array) or read_map(path)")


def _places(path: npt.ArrayLike) -> npt.NDArray[np.int64]:
    """A path from outside: whole numbers of at least 0."""
    hint = "give a row (column, row) for each place, or (column, row, level) by slices"
    try:
        array = np.asarray(path)
    except ValueError as error:
        raise bad("path", f"this is no path: {error}", hint) from None
    if array.size == 0:
        return np.empty((0, 2), dtype=np.int64)
    if array.ndim != 2 or array.shape[1] not in (2, 3) or array.dtype.kind not in "iu":
        raise bad("path", f"an array of shape {array.shape} and {array.dtype} is no path", hint)
    if (array < 0).any() or (array > 2**32 - 1).any():
        raise bad("path", "a path has no cells below 0 or above 2³² − 1", hint)
    return array.astype(np.int64)
