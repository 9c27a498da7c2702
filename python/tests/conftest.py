from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import formicarium

#: Two planners on one map with a claim, small enough for every test.
QUESTION = """\
format = "formicarium/question@1"
title = "Ants on a small map"
asks = "Are more ants better?"
seeds = { from = 1, count = 20 }

[[instances]]
id = "blocks"
map = "blocks.map"

[[entries]]
id = "few"
label = "five ants"
role = "baseline"
planner = "ant-system"
set = { ants = 5, iterations = 10 }

[[entries]]
id = "many"
label = "twenty ants"
role = "improved"
planner = "ant-system"
set = { ants = 20, iterations = 10 }

[[entries]]
id = "exact"
label = "A*"
role = "other"
planner = "astar"

[[claims]]
id = "shorter"
improved = "many"
baseline = "few"
measure = "length"
direction = "less"
says = "More ants find shorter paths."
"""


@pytest.fixture(scope="session")
def question(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The file of a question with its map beside it."""
    folder = tmp_path_factory.mktemp("question")
    assert formicarium.command(["generate", "random", "--size", "20x15", "--seed", "7", "--out", folder / "blocks.map"]) == 0
    (folder / "small.toml").write_text(QUESTION, encoding="utf-8")
    return folder / "small.toml"


@pytest.fixture(scope="session")
def compared(question: Path) -> formicarium.Comparison:
    with pytest.warns(formicarium.FormicariumWarning, match="no start and goal"):
        return formicarium.compare(question)


@pytest.fixture(scope="session")
def asked() -> dict[str, Any]:
    """A question as a dict, with its map in memory."""
    return {
        "seeds": 3,
        "instances": [{"id": "random", "map": formicarium.generate("random", 20, 15, seed=7)}],
        "entries": [
            {"id": "ants", "planner": "ant-system", "set": {"ants": 5, "iterations": 5}},
            {"id": "exact", "planner": "astar"},
        ],
    }
