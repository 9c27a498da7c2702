"""Optional packages, and what is said on the way in."""

from __future__ import annotations

import importlib
import warnings
from collections.abc import Iterable
from typing import Any

from .errors import ArgumentError, FormicariumWarning, MissingExtraError


def need(package: str, extra: str) -> Any:
    """An optional package, or the error that says how to get it."""
    try:
        return importlib.import_module(package)
    except ImportError as error:
        name = package.partition(".")[0]
        hint = f'pip install "formicarium[{extra}]", or {name} alone'
        raise MissingExtraError("missing-extra", name, f"{name} is not installed", hint) from error


def bad(field: str, message: str, hint: str) -> ArgumentError:
    """The error about an argument."""
    return ArgumentError("bad-argument", field, message, hint)


def warn(notices: Iterable[tuple[str, str]]) -> None:
    """Warns of each notice, seen from the caller of the function that calls this."""
    for kind, message in notices:
        warnings.warn(FormicariumWarning(message, kind), stacklevel=3)


def warn_of_lines(lines: Iterable[str]) -> None:
    """The same for lines as the command line prints them."""
    for line in lines:
        warnings.warn(FormicariumWarning(line.removeprefix("note: ")), stacklevel=3)
