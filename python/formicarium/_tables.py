"""Runs as tables: of a comparison, of its file, of a million of them. Columns have the names of the CSV."""

from __future__ import annotations

import csv
import io
import os
import tempfile
import warnings
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _engine
from ._cells import whole
from ._need import bad, need, warn_of_lines
from .errors import FormicariumWarning

if TYPE_CHECKING:
    from ._compare import Comparison

#: What stands in columns, by their names in any of the tables; in all others real numbers.
TEXTS = frozenset({"instance", "entry", "status", "objective", "digest", "test", "first", "second"})
COUNTS = frozenset({"seed", "turns", "iteration_of_best", "paths_to_best", "ant_moves", "iterations", "constructed_paths", "cell_expansions"})
FLAGS = frozenset({"proven"})

#: Runs that are held in memory at a time.
BATCH = 10_000


def records(text: str) -> list[dict[str, Any]]:
    """A table of the engine as dicts: numbers and flags by their columns, None where a field is empty."""
    return [{name: _plain(name, value) for name, value in row.items()} for row in csv.DictReader(io.StringIO(text))]


def _plain(name: str, value: str) -> Any:
    if name in TEXTS:
        return value
    if value == "":
        return None
    if name in FLAGS:
        return value == "true"
    return int(value) if name in COUNTS else float(value)


def table(text: str) -> Any:
    """A table of the engine as a ``pyarrow.Table``."""
    head, _, _ = text.partition("\n")
    pa, arrow = need("pyarrow", "arrow"), need("pyarrow.csv", "arrow")
    if not head:
        return pa.table({})
    return arrow.read_csv(io.BytesIO(text.encode()), convert_options=_types(head.split(",")))


def _types(names: list[str]) -> Any:
    """How the columns are read."""
    pa, arrow = need("pyarrow", "arrow"), need("pyarrow.csv", "arrow")
    kinds = ((TEXTS, pa.string()), (COUNTS, pa.int64()), (FLAGS, pa.bool_()))
    of = {name: next((kind for known, kind in kinds if name in known), pa.float64()) for name in names}
    return arrow.ConvertOptions(column_types=of, strings_can_be_null=False)


def texts(source: str | os.PathLike[str] | Comparison, batch: int = BATCH, question: Any = None) -> Iterator[tuple[str, str]]:
    """The lines of runs and of their improvements, some runs at a time, without heads: what every reader of this module is fed by."""
    from ._compare import Comparison

    if isinstance(source, Comparison):
        yield source.file("csv").partition("\n")[2], source._native.traces().partition("\n")[2]
        return
    path = os.fspath(source)
    stored = _journals(path, question) if Path(path).is_dir() else _engine.StoredRows(path)
    read = 0
    while True:
        lines, improvements, count = stored.next(batch)
        if count == 0:
            break
        read += count
        yield lines, improvements
    if stored.unlike > 0:
        said = f"{path}: two journals say different things of {stored.unlike} runs"
        raise bad("source", said, "`formicarium compare --merge` names them, and their files")
    if stored.missing > 0 and read == 0:
        raise bad("source", f"{path} has no run of this question", "give the question with the options that the shards had")
    if stored.dropped > 0:
        message = f"{path}: lines of its journals that do not hold, or are of another question, and are left out: {stored.dropped}"
        warnings.warn(FormicariumWarning(message, "journals-damaged"), stacklevel=3)
    if stored.missing > 0:
        message = f"{path}: {stored.missing} of {read + stored.missing} runs are missing: `formicarium compare --merge` lists their shards"
        warnings.warn(FormicariumWarning(message, "runs-missing"), stacklevel=3)


def _journals(folder: str, question: Any) -> _engine.StoredRows:
    """The journals in a folder, of shards or of a comparison that was broken off; each run once."""
    from ._compare import read_question

    if question is None:
        raise bad("question", f"{folder} has journals, which do not tell what was asked", "give the question as well, as `compare` takes it")
    paths = sorted(str(path) for path in Path(folder).iterdir() if path.suffix in (".journal", ".partial") and path.is_file())
    if not paths:
        raise bad("source", f"{folder} has no journal", "give the folder of `compare --shard`, or a comparison's .json")
    asked, lines = read_question(question, None, None, [])
    warn_of_lines(lines)
    return _engine.StoredRows.of_journals(paths, asked)


def rows(source: str | os.PathLike[str] | Comparison, *, question: Any = None, batch: int = BATCH) -> Iterator[Any]:
    """The runs of a comparison as ``pyarrow.RecordBatch``, at most ``batch`` at a time, so that a million need little memory. Needs pyarrow.

    ``source``: a Comparison, its document ``NAME.json``, its table ``NAME.csv``, or with its ``question`` a folder of journals, whose runs
    come in the order of the files. Lines that do not hold are left out, with a warning.
    """
    whole(batch, "batch", least=1)
    if _is_csv(source):
        return _csv_batches(os.fspath(source), batch)  # type: ignore[arg-type]
    return (one for lines, _ in texts(source, batch, question) for one in _batches(_engine.columns()[0], lines, batch))


def traces(source: str | os.PathLike[str] | Comparison, *, question: Any = None, batch: int = BATCH) -> Iterator[Any]:
    """Every improvement of every run as ``pyarrow.RecordBatch``, of at most ``batch`` runs at a time. Needs pyarrow.

    ``source``: a Comparison, its document ``NAME.json``, or with its ``question`` a folder of journals.
    """
    whole(batch, "batch", least=1)
    if _is_csv(source):
        raise bad("source", "a table of runs does not tell how they came to their paths", "give the comparison's .json")
    return (one for _, lines in texts(source, batch, question) for one in _batches(_engine.columns()[1], lines, None))


def _is_csv(source: Any) -> bool:
    return isinstance(source, (str, os.PathLike)) and os.fspath(source).lower().endswith(".csv")


def _batches(head: str, lines: str, most: int | None) -> Iterator[Any]:
    if lines:
        yield from table(f"{head}\n{lines}").combine_chunks().to_batches(max_chunksize=most)


def _csv_batches(path: str, batch: int) -> Iterator[Any]:
    arrow, head = need("pyarrow.csv", "arrow"), _engine.columns()[0]
    try:
        with open(path, encoding="utf-8") as file:
            found = file.readline(4096).rstrip("\r\n")
    except (OSError, UnicodeDecodeError) as error:
        raise bad("source", f"cannot read {path}: {error}", "check the name") from None
    if found != head:
        raise bad("source", f"{path} is no table of runs: it begins with `{found[:80]}`", f"give one that begins with {head}")
    with arrow.open_csv(path, convert_options=_types(head.split(","))) as reader:
        for one in reader:
            for at in range(0, one.num_rows, batch):
                yield one.slice(at, batch)


def write_parquet(
    source: str | os.PathLike[str] | Comparison,
    *,
    rows: str | os.PathLike[str] | None = None,
    traces: str | os.PathLike[str] | None = None,
    question: Any = None,
    batch: int = BATCH,
) -> None:
    """Writes runs and improvements as Parquet, each into the file that is named; some at a time. A file is there when it is whole. Needs pyarrow.

    ``source``: a Comparison, its document ``NAME.json``, with its ``question`` a folder of journals, or, for ``rows`` alone, a table ``NAME.csv``.
    """
    whole(batch, "batch", least=1)
    if rows is None and traces is None:
        raise bad("rows", "nothing is to be written", "name a file for rows, for traces, or for both")
    files = [os.path.realpath(os.fspath(path)) for path in (source, rows, traces) if isinstance(path, (str, os.PathLike))]
    if len(set(files)) < len(files):
        raise bad("rows", "one file cannot be read from and written to, or hold both", "give rows and traces files of their own")
    heads = _engine.columns()
    with ExitStack() as stack:
        to_rows = None if rows is None else stack.enter_context(_writer(os.fspath(rows), heads[0]))
        to_traces = None if traces is None else stack.enter_context(_writer(os.fspath(traces), heads[1]))
        if _is_csv(source):
            if to_rows is None or to_traces is not None:
                raise bad("traces", "a table of runs has no improvements", "give the comparison's .json")
            for one in _csv_batches(os.fspath(source), batch):  # type: ignore[arg-type]
                to_rows.write_batch(one)
            return
        for lines, improvements in texts(source, batch, question):
            for writer, head, text in ((to_rows, heads[0], lines), (to_traces, heads[1], improvements)):
                if writer is not None and text:
                    writer.write_table(table(f"{head}\n{text}"))


@contextmanager
def _writer(path: str, head: str) -> Iterator[Any]:
    """A Parquet file that gets its name when it is whole."""
    parquet = need("pyarrow.parquet", "arrow")
    whole = Path(path).absolute()
    if not whole.parent.is_dir():
        raise bad("rows", f"{whole.parent} is no folder", "make it first")
    with tempfile.TemporaryDirectory(prefix=".formicarium-", dir=whole.parent) as beside:
        unfinished = Path(beside) / whole.name
        with parquet.ParquetWriter(unfinished, table(f"{head}\n").schema) as writer:
            yield writer
        unfinished.replace(whole)
