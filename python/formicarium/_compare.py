"""Many runs of many planners on many maps, and what they say."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from . import _engine
from ._cells import whole
from ._map import Map, _json, read_map
from ._need import bad, warn_of_lines
from ._tables import records, table
from .errors import FileError


class Comparison:
    """The runs of a question, and what they say. Every number is that of ``formicarium compare``, its texts are the same bytes."""

    def __init__(self, native: _engine.Comparison) -> None:
        self._native = native
        self._texts: dict[tuple[str, str], str] = {}
        self._analysed: dict[str, Any] | None = None

    @property
    def question(self) -> dict[str, Any]:
        """What was asked: ``formicarium/question@1``."""
        question: dict[str, Any] = json.loads(self._native.question)
        return question

    def file(self, kind: str, language: str = "en") -> str:
        """The contents of a result file by its kind as ``compare --files`` names it: csv, markdown, tests-csv, summary-json, latex …"""
        if (kind, language) not in self._texts:
            [self._texts[kind, language]] = self._native.files([kind], language)
        return self._texts[kind, language]

    @property
    def rows(self) -> Any:
        """One row a run, as a ``pyarrow.Table`` with the columns of the CSV; ``.to_pandas()`` gives a frame. Needs pyarrow."""
        return table(self.file("csv"))

    @property
    def traces(self) -> Any:
        """One row an improvement, as a ``pyarrow.Table``: instance, entry, seed, value and what had been spent. Needs pyarrow."""
        return table(self._native.traces())

    @property
    def tests(self) -> Any:
        """Rank tests of every pair of entries, as a ``pyarrow.Table``. Needs pyarrow."""
        return table(self.file("tests-csv"))

    def records(self) -> list[dict[str, Any]]:
        """The rows as dicts, without pyarrow; None where nothing is known."""
        return records(self.file("csv"))

    @property
    def summary(self) -> dict[str, Any]:
        """Every statistic of every entry and map, tests and verdicts: ``formicarium/summary@1``."""
        summary: dict[str, Any] = json.loads(self.file("summary-json"))
        return summary

    @property
    def analysis(self) -> dict[str, Any]:
        """The same and more, as the engine has it: curves, ranks, shares."""
        if self._analysed is None:
            self._analysed = json.loads(self._native.analysis())
        return self._analysed

    @property
    def verdicts(self) -> list[dict[str, Any]]:
        """What became of each claim of the question."""
        verdicts: list[dict[str, Any]] = self.analysis["verdicts"]
        return verdicts

    def markdown(self, language: str = "en") -> str:
        """Tables and verdicts as Markdown; ``language``: en or zh-CN."""
        return self.file("markdown", language)

    def document(self) -> str:
        """Question, maps and runs in one text, ``formicarium/comparison@1``: the page and the command line open it and verify it."""
        return self.file("json")

    def write(
        self, folder: str | os.PathLike[str], name: str, kinds: Iterable[str] = ("csv", "markdown", "json"), *, replace: bool = False
    ) -> list[Path]:
        """Writes result files ``NAME.…`` into a folder, which is made. Gives their paths. Files of these names are replaced only if ``replace``."""
        endings, made = dict(_engine.Comparison.kinds()), []
        if Path(name).name != name or name in ("", ".", ".."):
            raise bad("name", f"{name!r} is no name of a file", "give the folder by itself, and a name without separators")
        texts = [(kind, self.file(kind)) for kind in kinds]
        there = [path for kind, _ in texts if (path := Path(folder) / f"{name}.{endings[kind]}").exists()]
        if there and not replace:
            raise FileError("file", "name", f"{there[0]} is there already", "choose another name or folder, or replace=True")
        Path(folder).mkdir(parents=True, exist_ok=True)
        for kind, text in texts:
            path = Path(folder) / f"{name}.{endings[kind]}"
            path.write_bytes(text.encode())
            made.append(path)
        return made

    def __repr__(self) -> str:
        question = self.question
        asked = f"{len(question['instances'])} maps × {len(question['entries'])} entries × {question['seeds']['count']} seeds"
        return f"<formicarium.Comparison {question['title']!r}: {asked}>"


def compare(
    question: str | os.PathLike[str] | Mapping[str, Any],
    *,
    seeds: int | None = None,
    only: str | Iterable[str] | None = None,
    budget: str | tuple[str, int] | None = None,
    jobs: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Comparison:
    """Runs a question: every entry on every map with every seed, on all cores.

    ``question``: a file as ``formicarium compare`` reads it, or a dict of the same fields (docs/methodology.md). In a dict the ``map`` of an
    instance is a ``Map`` or a file's path, ``seeds`` may be a number, and what has a default may be left out.

    ``seeds``: only the question's first so many. ``only``: instances, or groups of them. ``budget``: what a run may spend, as
    ``"constructed-paths=2000"`` or ``("constructed-paths", 2000)``. ``jobs``: threads, all cores if None. ``progress(done, of)`` is called on this
    thread. Other Python threads go on meanwhile; Ctrl-C ends it after the runs that have begun.
    """
    count = None if seeds is None else whole(seeds, "seeds", least=1)
    threads = 0 if jobs is None else whole(jobs, "jobs", least=1, most=1024)
    ids = [only] if isinstance(only, str) else list(only or ())
    spend = f"{budget[0]}={budget[1]}" if isinstance(budget, tuple) and len(budget) == 2 else budget
    if spend is not None and not isinstance(spend, str):
        raise bad("budget", f"budget = {budget!r} cannot be used", 'give "constructed-paths=2000", or the axis and the amount')
    asked, lines = read_question(question, count, spend, ids)
    warn_of_lines(lines)
    return Comparison(asked.run(threads, progress))


def read_question(
    question: str | os.PathLike[str] | Mapping[str, Any], seeds: int | None, budget: str | None, only: list[str]
) -> tuple[_engine.Comparison, list[str]]:
    """A question with its maps, nothing run, and what is worth saying about its files."""
    if isinstance(question, Mapping):
        return _of_dict(question, seeds, budget, only), []
    arguments = [f"--only={one}" for one in only] + ["--document"]
    arguments += [] if seeds is None else [f"--seeds={seeds}"]
    arguments += [] if budget is None else [f"--budget={budget}"]
    return _engine.read_question([*arguments, "--", os.fspath(question)])


def _of_dict(question: Mapping[str, Any], seeds: int | None, budget: str | None, only: list[str]) -> _engine.Comparison:
    """A question with its maps, what has a default filled in."""
    filled = {"format": "formicarium/question@1", "title": "", "asks": "", **question}
    if not isinstance(filled.get("seeds"), Mapping):
        filled["seeds"] = {"from": 1, "count": whole(filled.get("seeds", seeds), "seeds", least=1)}
    maps, instances = [], []
    for instance in _dicts(question, "instances"):
        given = instance.get("map")
        read = given if isinstance(given, Map) else read_map(_path(given, instance))
        maps.append(read._native)
        name = f"{read.name or instance.get('id', 'map')}.json" if isinstance(given, Map) else os.path.basename(_path(given, instance))
        instances.append({**instance, "map": name})
    entries = [{"label": entry.get("id"), "role": "other", **entry} for entry in _dicts(question, "entries")]
    filled.update(instances=instances, entries=entries)
    return _engine.ask(_json(filled, "question"), maps, seeds, budget, only)


def _path(given: Any, instance: Mapping[str, Any]) -> str:
    try:
        return str(os.fspath(given))
    except TypeError:
        message = f"the map of instance {instance.get('id')!r} is {type(given).__name__}"
        raise bad("instances", message, "give a formicarium.Map, or the path of a file") from None


def _dicts(question: Mapping[str, Any], field: str) -> list[Mapping[str, Any]]:
    listed = question.get(field)
    if isinstance(listed, (str, Mapping)) or not isinstance(listed, Iterable) or not all(isinstance(one, Mapping) for one in listed):
        raise bad(field, f"`{field}` of the question is no list of dicts", "see docs/methodology.md")
    return list(listed)
