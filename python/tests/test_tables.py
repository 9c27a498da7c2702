from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

import formicarium
from formicarium import errors

pa = pytest.importorskip("pyarrow")


@pytest.fixture(scope="module")
def stored(compared: formicarium.Comparison, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("stored")
    compared.write(folder, "small")
    return folder


def test_rows_and_traces_come_in_batches_from_anywhere(compared: formicarium.Comparison, stored: Path) -> None:
    for source in (compared, stored / "small.json", stored / "small.csv"):
        batches = list(formicarium.rows(source, batch=5))
        assert max(batch.num_rows for batch in batches) <= 5
        assert pa.Table.from_batches(batches) == compared.rows
    for source in (compared, stored / "small.json"):
        assert pa.Table.from_batches(formicarium.traces(source, batch=5)) == compared.traces


def test_a_document_that_is_laid_out_otherwise_is_read_too(compared: formicarium.Comparison, tmp_path: Path) -> None:
    for indent in (None, 2):
        (tmp_path / "other.json").write_text(json.dumps(json.loads(compared.document()), indent=indent), encoding="utf-8")
        assert pa.Table.from_batches(formicarium.rows(tmp_path / "other.json")) == compared.rows


def test_parquet_holds_the_same(compared: formicarium.Comparison, stored: Path, tmp_path: Path) -> None:
    from pyarrow import parquet

    formicarium.write_parquet(stored / "small.json", rows=tmp_path / "rows.parquet", traces=tmp_path / "traces.parquet", batch=4)
    assert parquet.read_table(tmp_path / "rows.parquet") == compared.rows
    assert parquet.read_table(tmp_path / "traces.parquet") == compared.traces
    formicarium.write_parquet(stored / "small.csv", rows=tmp_path / "again.parquet")
    assert parquet.read_table(tmp_path / "again.parquet") == compared.rows
    with pytest.raises(errors.ArgumentError, match="no improvements"):
        formicarium.write_parquet(stored / "small.csv", rows=tmp_path / "r", traces=tmp_path / "t")
    with pytest.raises(errors.ArgumentError, match="nothing"):
        formicarium.write_parquet(stored / "small.json")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["again.parquet", "rows.parquet", "traces.parquet"]


@pytest.mark.filterwarnings("ignore:.*no start and goal")
def test_journals_of_shards_give_each_run_once(compared: formicarium.Comparison, question: Path, tmp_path: Path) -> None:
    for shard in ("1/2", "2/2", "1/3"):
        assert formicarium.command(["compare", question, "--shard", shard, "--out", tmp_path]) == 0
    order = [("instance", "ascending"), ("entry", "ascending"), ("seed", "ascending")]
    read = pa.Table.from_batches(formicarium.rows(tmp_path, question=question, batch=7))
    assert read.sort_by(order) == compared.rows.sort_by(order)
    journal = next(tmp_path.glob("*1of2*"))
    text = journal.read_text().splitlines(keepends=True)
    journal.write_text("".join(text[:2]) + text[2].replace("status", "statut") + "".join(text[3:]))
    for path in tmp_path.glob("*1of3*"):
        path.unlink()
    with pytest.warns(formicarium.FormicariumWarning) as told:
        assert sum(batch.num_rows for batch in formicarium.rows(tmp_path, question=question)) == 59
    said = [str(warning.message) for warning in told]
    assert any("left out: 1" in text for text in said)
    assert any("1 of 60 runs are missing" in text for text in said)
    (tmp_path / "other").mkdir()
    assert formicarium.command(["compare", question, "--seeds", "2", "--shard", "1/2", "--out", tmp_path / "other"]) == 0
    with pytest.warns(formicarium.FormicariumWarning), pytest.raises(errors.ArgumentError, match="no run of this question"):
        list(formicarium.rows(tmp_path / "other", question=question))
    with pytest.raises(errors.ArgumentError, match="what was asked"):
        list(formicarium.rows(tmp_path))
    with pytest.raises(errors.ArgumentError, match="merge"):
        formicarium.to_iohanalyzer(tmp_path, tmp_path / "ioh")
    (tmp_path / "empty").mkdir()
    with pytest.raises(errors.ArgumentError, match="no journal"):
        list(formicarium.traces(tmp_path / "empty", question=question))


def test_what_is_no_comparison_is_refused_by_name(stored: Path, tmp_path: Path) -> None:
    whole = (stored / "small.json").read_text()
    (tmp_path / "cut.json").write_text(whole[: len(whole) // 2], encoding="utf-8")
    (tmp_path / "line.json").write_text(whole.replace('"status":"budget-spent"', '"status":"spent"', 1), encoding="utf-8")
    (tmp_path / "other.csv").write_text("a,b\n1,2\n", encoding="utf-8")
    for name in ("cut.json", "line.json", "other.csv", "none.json", "none.csv"):
        with pytest.raises(errors.FormicariumError, match=name):
            list(formicarium.rows(tmp_path / name))
    with pytest.raises(errors.FormicariumError, match="cut"):
        formicarium.write_parquet(tmp_path / "cut.json", rows=tmp_path / "rows.parquet")
    assert not list(tmp_path.glob("*parquet*"))
    with pytest.raises(errors.ArgumentError, match="table of runs"):
        formicarium.traces(stored / "small.csv")
    with pytest.raises(errors.ArgumentError, match="batch"):
        formicarium.rows(stored / "small.json", batch=0)


def test_many_rows_need_little_memory(stored: Path, tmp_path: Path) -> None:
    """A document of 200,000 runs, 60 MB, in a process of its own: its memory grows by less than a third of that."""
    head, _, rows = (stored / "small.json").read_text().rpartition('"rows": [\n')
    row = rows.splitlines()[0].rstrip(",]}") + "}"
    count = 200_000
    with open(tmp_path / "many.json", "w", encoding="utf-8") as file:
        file.write(head.replace('"count":20', '"count":100000') + '"rows": [\n')
        for at in range(count):
            entry, seed = divmod(at, 100_000)
            task = f'"task":{{"instance":0,"entry":{entry},"seed":{seed + 1}}}'
            file.write(row.replace('"task":{"instance":0,"entry":0,"seed":1}', task) + (",\n" if at + 1 < count else "]}\n"))
    code = (
        "import resource, sys, formicarium\n"
        "next(formicarium.rows(sys.argv[1], batch=10))\n"
        "before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
        "formicarium.write_parquet(sys.argv[1], rows=sys.argv[1] + '.parquet')\n"
        "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)\n"
    )
    grown = int(subprocess.run([sys.executable, "-c", code, str(tmp_path / "many.json")], capture_output=True, check=True, text=True).stdout)
    size = (tmp_path / "many.json").stat().st_size
    from pyarrow import parquet

    assert parquet.read_metadata(tmp_path / "many.json.parquet").num_rows == count
    assert grown * 1024 < size / 3 + 30e6, (grown, size)


def test_iohprofilers_files_are_read_by_us_and_by_iohinspector(compared: formicarium.Comparison, question: Path, tmp_path: Path) -> None:
    described = formicarium.to_iohanalyzer(compared, tmp_path / "ioh")
    assert len(described) == 3
    many = tmp_path / "ioh" / "many" / "data_f1_blocks" / "IOHprofiler_f1_DIM1.dat"
    beside = ["compare", str(question), "--out", str(tmp_path / "beside"), "--results", f"blocks={many}"]
    assert formicarium.command(beside) == 0
    theirs = [line.split(",") for line in (tmp_path / "beside" / "small.csv").read_text().splitlines()]
    ours = {row["seed"]: row for row in compared.records() if row["entry"] == "many"}
    value, seed, entry, paths = (theirs[0].index(name) for name in ("value", "seed", "entry", "paths_to_best"))
    known = ("few", "many", "exact", "entry")
    imported = {int(line[seed]): (float(line[value]), int(line[paths])) for line in theirs if line[entry] not in known}
    assert imported == {seed: (row["value"], row["paths_to_best"]) for seed, row in ours.items()}

    inspector = pytest.importorskip("iohinspector")
    manager = inspector.DataManager()
    manager.add_folder(str(tmp_path / "ioh"))
    overview = {(row["algorithm_name"], row["run_id"]): row["best_y"] for row in manager.overview.to_dicts()}
    assert overview == pytest.approx({(row["entry"], row["seed"]): row["value"] for row in compared.records()}, abs=1e-6)
    loaded = manager.load(monotonic=False, include_meta_data=True)
    assert loaded.columns == [*manager.overview.columns, "evaluations", "raw_y"]
    best = {(row["algorithm_name"], row["run_id"]): row["raw_y"] for row in loaded.to_dicts()}
    assert best == overview
    with pytest.raises(errors.ArgumentError, match="nothing that is counted"):
        formicarium.to_iohanalyzer(compared, tmp_path, axis="seconds")
