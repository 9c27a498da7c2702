"""Ant-colony path planning beside exact planners: seeded runs with the same bits on every machine.

A cell is (column, row), counted from 0 at the upper left; arrays are [row, column].

>>> import numpy as np, formicarium
>>> field = formicarium.Map(np.zeros((5, 8), dtype=bool), start=(0, 0), goals=(7, 4))
>>> formicarium.plan(field, "astar").path.shape
(8, 2)
"""

from . import errors
from ._command import command
from ._compare import Comparison, compare
from ._engine import version as _version
from ._iohanalyzer import to_iohanalyzer
from ._map import Cell, Map, catalog, generate, read_map
from ._plan import Plan, check, plan
from ._tables import rows, traces, write_parquet
from .errors import FormicariumError, FormicariumWarning

__version__ = _version()

__all__ = [
    "Cell",
    "Comparison",
    "FormicariumError",
    "FormicariumWarning",
    "Map",
    "Plan",
    "catalog",
    "check",
    "command",
    "compare",
    "errors",
    "generate",
    "plan",
    "read_map",
    "rows",
    "to_iohanalyzer",
    "traces",
    "write_parquet",
]
