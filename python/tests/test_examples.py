from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = sorted((Path(__file__).parent.parent / "examples").glob("*.py"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.stem)
def test_an_example_runs_and_is_short(example: Path, tmp_path: Path) -> None:
    if example.stem == "figure":
        pytest.importorskip("matplotlib")
        pytest.importorskip("pandas")
    assert len(example.read_text(encoding="utf-8").splitlines()) <= 40
    done = subprocess.run([sys.executable, example], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    told = {"ros_map_to_path": "optimal", "tune_and_compare": "tuned: ", "figure": ""}[example.stem]
    assert told in done.stdout
    assert [path.name for path in tmp_path.iterdir()] == (["figure.svg"] if example.stem == "figure" else [])
