from __future__ import annotations

import signal
import subprocess
import sys
import sysconfig
import time
from pathlib import Path

import pytest

import formicarium
from formicarium import errors
from formicarium._need import need

SCRIPT = Path(sysconfig.get_path("scripts")) / "formicarium"


def test_exit_codes_are_the_programs(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert formicarium.command(["generate", "maze", "--size", "9x9", "--out", tmp_path / "maze.map"]) == 0
    assert formicarium.command(["plan", tmp_path / "maze.map", "--planner", "astar"]) == 0
    assert "optimal (proven)" in capfd.readouterr().out
    (tmp_path / "path.csv").write_text("0,0\n5,5\n", encoding="ascii")
    assert formicarium.command(["check", tmp_path / "path.csv", "--map", tmp_path / "maze.map"]) == 1
    assert formicarium.command(["plan", tmp_path / "none.map", "--planner", "astar"]) == 2
    assert "No such file" in capfd.readouterr().err
    with pytest.raises(errors.ArgumentError, match="list of arguments"):
        formicarium.command("catalog")
    assert formicarium.command(["--version"]) == 0
    assert formicarium.__version__ in capfd.readouterr().out


@pytest.mark.skipif(not SCRIPT.exists(), reason="the package is not installed")
def test_the_console_script_is_the_program() -> None:
    told = subprocess.run([SCRIPT, "catalog"], capture_output=True, check=True, text=True).stdout
    assert "ant-system" in told
    assert subprocess.run([SCRIPT, "plan", "none.map", "--planner", "astar"], capture_output=True).returncode == 2


def test_ctrl_c_ends_the_program_at_once(tmp_path: Path) -> None:
    assert formicarium.command(["generate", "random", "--size", "400x400", "--out", tmp_path / "large.map"]) == 0
    program = [sys.executable, "-m", "formicarium", "plan", str(tmp_path / "large.map"), "--planner", "ant-system", "--set", "iterations=100000"]
    with subprocess.Popen(program, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as child:
        # It says that it chose the ends, and plans.
        assert child.stderr is not None
        assert b"note" in child.stderr.readline()
        time.sleep(0.2)
        child.send_signal(signal.SIGINT)
        child.communicate()
        assert child.returncode == -signal.SIGINT


def test_a_missing_package_says_how_to_get_it() -> None:
    with pytest.raises(errors.MissingExtraError, match=r'pip install "formicarium\[plot\]"') as refused:
        need("no_such_package.part", "plot")
    assert isinstance(refused.value, ImportError)
    assert refused.value.field == "no_such_package"
