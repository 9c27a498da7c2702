"""Runs as IOHprofiler's files, which IOHanalyzer and IOHinspector read."""

from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _engine
from ._need import bad
from ._tables import texts

if TYPE_CHECKING:
    from ._compare import Comparison

#: What may count as an evaluation: columns of the traces.
AXES = ("constructed_paths", "ant_moves", "cell_expansions", "iterations")

#: Before its first path a run has found nothing: its value is infinite.
NOTHING = float("inf")


def to_iohanalyzer(source: str | os.PathLike[str] | Comparison, folder: str | os.PathLike[str], *, axis: str = "constructed_paths") -> list[Path]:
    """Writes the runs as IOHprofiler's files: a folder for each entry, in it a ``.json`` and a ``.dat`` for each map. Gives the ``.json`` files.

    An entry is an algorithm, a map a function, a seed a run, in the order of the seeds. ``axis`` counts as evaluations: ``constructed_paths``,
    ``ant_moves``, ``cell_expansions`` or ``iterations``; of planners that count none of it every improvement comes at evaluation 1. Values are
    those of the planner's own objective, to be made small; infinite before the first path and where there is none. The dimension says nothing.
    """
    if axis not in AXES:
        raise bad("axis", f"`{axis}` is nothing that is counted", f"give one of {', '.join(AXES)}")
    if isinstance(source, (str, os.PathLike)) and Path(source).is_dir():
        raise bad("source", f"{os.fspath(source)} is a folder", "merge its journals: `formicarium compare QUESTION --merge FOLDER`")
    made: list[Path] = []
    functions: dict[str, int] = {}
    for (instance, entry), runs in groupby(_runs(source, axis), key=lambda run: run[0]):
        number = functions.setdefault(instance, len(functions) + 1)
        made.append(_write(Path(folder) / entry, number, (instance, entry), [steps for _, steps in runs]))
    return made


def _runs(source: Any, axis: str) -> Iterator[tuple[tuple[str, str], list[tuple[int, float]]]]:
    """Each run's instance and entry, and its improvements as evaluations and value, in the order of the rows."""
    heads = [head.split(",") for head in _engine.columns()]
    for lines, improvements in texts(source):
        found: dict[tuple[str, str, str], list[tuple[int, float]]] = {}
        for step in csv.DictReader(io.StringIO(improvements), heads[1]):
            # A count that is not known, and one of 0, come at the first evaluation.
            at = max(int(step[axis] or 0), 1)
            found.setdefault((step["instance"], step["entry"], step["seed"]), []).append((at, float(step["value"])))
        for row in csv.DictReader(io.StringIO(lines), heads[0]):
            yield (row["instance"], row["entry"]), found.get((row["instance"], row["entry"], row["seed"]), [])


def _steps(improvements: list[tuple[int, float]]) -> list[tuple[int, float]]:
    """One record an evaluation, best so far, beginning with evaluation 1: by that readers tell runs apart."""
    best: dict[int, float] = {1: NOTHING}
    for at, value in improvements:
        best[at] = min(value, *best.values())
    return sorted(best.items())


def _write(folder: Path, number: int, names: tuple[str, str], runs: list[list[tuple[int, float]]]) -> Path:
    instance, entry = names
    data = Path(f"data_f{number}_{instance}") / f"IOHprofiler_f{number}_DIM1.dat"
    (folder / data).parent.mkdir(parents=True, exist_ok=True)
    told = []
    with open(folder / data, "w", encoding="ascii", newline="\n") as file:
        for run in runs:
            steps = _steps(run)
            file.write("evaluations raw_y\n")
            file.writelines(f"{at} {value!r}\n" for at, value in steps)
            evaluations, value = steps[-1]
            told.append({"instance": 1, "evals": evaluations, "best": {"evals": evaluations, "y": value, "x": []}})
    described = {
        "version": f"formicarium {_engine.version()}",
        "suite": "formicarium",
        "function_id": number,
        "function_name": instance,
        "maximization": False,
        "algorithm": {"name": entry, "info": entry},
        "attributes": ["evaluations", "raw_y"],
        "scenarios": [{"dimension": 1, "path": data.as_posix(), "runs": told}],
    }
    path = folder / f"IOHprofiler_f{number}_{instance}.json"
    path.write_text(json.dumps(described, indent=1), encoding="utf-8")
    return path
