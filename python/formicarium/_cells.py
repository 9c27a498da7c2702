"""Cells and arrays: what comes in is checked by name, never bent to fit.

A cell is (column, row), counted from 0 at the upper left. Arrays are [row, column].
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from operator import index
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _engine
from ._need import bad

#: Rows and columns that a map has at most.
MAX_SIDE: int = json.loads(_engine.catalog())["limits"]["max_side"]

#: Largest whole number that the engine counts cells and seeds in.
MOST = 2**32 - 1


def whole(value: Any, field: str, least: int = 0, most: int = MOST) -> int:
    """A whole number within a range."""
    try:
        number = index(value)
    except TypeError:
        raise bad(field, f"{field} = {value!r} is no whole number", f"give {least} to {most}") from None
    if isinstance(value, (bool, np.bool_)) or not least <= number <= most:
        raise bad(field, f"{field} = {value!r} cannot be used", f"give a whole number from {least} to {most}")
    return number


def cell(value: Any, field: str) -> tuple[int, int]:
    """A cell as (column, row)."""
    try:
        x, y = value
    except (TypeError, ValueError):
        raise bad(field, f"{field} = {value!r} is no cell", "give (column, row), counted from 0 at the upper left") from None
    return whole(x, field), whole(y, field)


def cells(value: Any, field: str) -> list[tuple[int, int]]:
    """One cell, or several."""
    if isinstance(value, (str, bytes)) or not isinstance(value, (Iterable, np.ndarray)):
        raise bad(field, f"{field} = {value!r} is no cell", "give (column, row), or a list of such")
    given: Sequence[Any] = list(value)
    if len(given) == 2 and not isinstance(given[0], (Sequence, np.ndarray)):
        return [cell(given, field)]
    return [cell(one, field) for one in given]


def blocked_bytes(value: Any) -> tuple[tuple[int, int], bytes]:
    """Columns and rows, and one byte a cell, of an array [row, column] of bool or of 0 and 1."""
    array = two_dimensional(value, "blocked")
    if array.dtype.kind == "b":
        return shape(array), np.ascontiguousarray(array, dtype=np.uint8).tobytes()
    if array.dtype.kind not in "iu":
        raise bad("blocked", f"an array of {array.dtype} is no map", "give bool, or whole numbers 0 (free) and 1 (blocked)")
    wrong = (array != 0) & (array != 1)
    if wrong.any():
        row, column = (int(i) for i in np.argwhere(wrong)[0])
        message = f"blocked[{row}, {column}] = {array[row, column]} is neither 0 nor 1"
        raise bad("blocked", message, "give 0 (free) and 1 (blocked); `array != 0` makes every other number a wall")
    return shape(array), np.ascontiguousarray(array, dtype=np.uint8).tobytes()


def height_bytes(value: Any) -> tuple[tuple[int, int], bytes]:
    """Columns and rows, and little-endian f32, of an array [row, column] of numbers; NaN = no data."""
    array = two_dimensional(value, "heights")
    if array.dtype.kind not in "iuf":
        raise bad("heights", f"an array of {array.dtype} has no heights", "give numbers, NaN where there is no data")
    with np.errstate(over="ignore"):
        made = np.ascontiguousarray(array, dtype="<f4")
    if np.isinf(made).any():
        row, column = (int(i) for i in np.argwhere(np.isinf(made))[0])
        message = f"heights[{row}, {column}] = {array[row, column]} is no height"
        raise bad("heights", message, "give finite numbers that float32 holds, NaN where there is no data")
    return shape(array), made.tobytes()


def factor_bytes(value: Any) -> tuple[tuple[int, int], bytes]:
    """Columns and rows, and little-endian f32, of an array [row, column] of numbers; the engine says which can be."""
    array = two_dimensional(value, "factors")
    if array.dtype.kind not in "iuf":
        raise bad("factors", f"an array of {array.dtype} has no factors", "give numbers from 1")
    with np.errstate(over="ignore"):
        return shape(array), np.ascontiguousarray(array, dtype="<f4").tobytes()


def two_dimensional(value: Any, field: str) -> npt.NDArray[Any]:
    """An array with rows and columns, and not more of them than a map may have."""
    if np.ma.isMaskedArray(value):
        raise bad(field, "a masked array hides what its masked cells are", "give a plain array: fill the masked cells")
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise bad(field, f"this is no array: {error}", "give an array [row, column]") from None
    if array.ndim != 2 or array.size == 0:
        message = f"an array of shape {array.shape} is no map"
        raise bad(field, message, "give an array [row, column] with at least one cell")
    if max(array.shape) > MAX_SIDE:
        message = f"an array of shape {array.shape} is larger than a map may be"
        raise bad(field, message, f"give at most {MAX_SIDE} rows and columns")
    return array


def shape(array: npt.NDArray[Any]) -> tuple[int, int]:
    """Columns and rows of an array [row, column]."""
    rows, columns = array.shape
    return int(columns), int(rows)
