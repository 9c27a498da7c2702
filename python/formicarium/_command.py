"""The command line, from Python and as a console script."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Iterable

from . import _engine
from ._need import bad


def command(args: Iterable[str | os.PathLike[str]]) -> int:
    """Runs ``formicarium`` with these arguments and returns its exit code: 0 fine, 1 no path or a failed check, 2 unusable input.

    It prints as the program does, on the process's own streams. Other Python threads go on meanwhile.
    """
    if isinstance(args, (str, bytes)):
        raise bad("args", "one text is no list of arguments", 'give a list such as ["plan", "maze.map", "--planner", "astar"]')
    sys.stdout.flush()
    sys.stderr.flush()
    return _engine.command([os.fspath(argument) for argument in args])


def main() -> None:
    """The console script. Ctrl-C ends it at once: what a comparison has done is in its journal. So does a closed pipe."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(command(sys.argv[1:]))
