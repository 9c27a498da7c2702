from __future__ import annotations

import doctest
import re
from pathlib import Path
from typing import Any

import pytest

import formicarium

PACKAGE = Path(__file__).parents[1]


@pytest.mark.parametrize("readme", [PACKAGE / "README.md", PACKAGE.parent / "README.md"], ids=["package", "project"])
def test_what_the_readme_shows_runs(readme: Path) -> None:
    pytest.importorskip("pandas")
    shown = re.findall(r"^```python\n(.*?)^```", readme.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)
    assert shown
    names: dict[str, Any] = {}
    for code in shown:
        exec(code, names)
    assert names["plan"].found


def test_what_the_package_says_of_itself_holds() -> None:
    assert doctest.testmod(formicarium).failed == 0
    assert formicarium.__doc__ is not None
    assert all(getattr(formicarium, name).__doc__ for name in formicarium.__all__)
