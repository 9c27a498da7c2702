from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

import formicarium

pytest.importorskip("distributed")

DRIVER = Path(__file__).parents[2] / "campaigns" / "dask_shards.py"

#: A stand-in for the package: a shard is a file, shard 2 fails at its first attempt, shard 3 always if it is told so.
STAND_IN = """\
import os, pathlib, sys

def command(arguments):
    if "--list-shards" in arguments:
        print("question.0123456789abcdef.shard-1of1.journal")
        return 0
    options = dict(zip(arguments[2::2], arguments[3::2]))
    if "--merge" in options:
        folder = pathlib.Path(options["--merge"])
        (folder.parent.parent / "merged").write_text(" ".join(sorted(path.name for path in folder.glob("shard-*"))))
        return 0
    number = options["--shard"].partition("/")[0]
    folder = pathlib.Path(options["--out"])
    folder.mkdir(parents=True, exist_ok=True)
    if number == os.environ.get("BROKEN"):
        return 2
    if number == "2" and not (folder / "attempt").exists():
        (folder / "attempt").touch()
        return 2
    (folder / f"shard-{number}").touch()
    return 0

if __name__ == "__main__":
    sys.exit(command(sys.argv[1:]))
"""


def driven(tmp_path: Path, **more: str) -> subprocess.CompletedProcess[str]:
    (tmp_path / "formicarium.py").write_text(STAND_IN, encoding="ascii")
    program = [sys.executable, str(DRIVER), "question.toml", "out", "--shards", "5", "--processes", "2", "--retries", "1"]
    return subprocess.run(program, env={**os.environ, "PYTHONPATH": str(tmp_path), **more}, capture_output=True, text=True, cwd=tmp_path)


def test_every_shard_is_done_retried_told_and_merged(tmp_path: Path) -> None:
    done = driven(tmp_path)
    assert done.returncode == 0, done.stderr
    told = done.stdout.splitlines()
    assert sorted(line.split()[1] for line in told) == [f"{number}/5" for number in range(1, 6)]
    assert all(" done in " in line for line in told)
    assert (tmp_path / "out" / "shards" / "0123456789abcdef" / "attempt").exists()
    assert (tmp_path / "out" / "merged").read_text() == "shard-1 shard-2 shard-3 shard-4 shard-5"


def test_what_stays_broken_is_named_and_nothing_is_merged(tmp_path: Path) -> None:
    done = driven(tmp_path, BROKEN="3")
    assert done.returncode == 1
    assert "shard 3/5 failed: `formicarium compare " in done.stdout
    assert "not merged: the shards 3 are missing" in done.stderr
    assert not (tmp_path / "out" / "merged").exists()


def test_the_real_engine_gives_the_bytes_of_one_process(tmp_path: Path, question: Path) -> None:
    options = ["--seeds", "4"]
    assert formicarium.command(["compare", str(question), *options, "--out", str(tmp_path / "whole")]) == 0
    program = [sys.executable, str(DRIVER), str(question), str(tmp_path / "out"), "--shards", "6", "--processes", "2"]
    subprocess.run([*program, "--options", " ".join(options), "--recheck", "10%"], check=True, cwd=tmp_path)
    whole, results = tmp_path / "whole", tmp_path / "out" / "results"
    names = sorted(path.name for path in whole.iterdir())
    assert names == sorted(path.name for path in results.iterdir())
    assert all((whole / name).read_bytes() == (results / name).read_bytes() for name in names)
