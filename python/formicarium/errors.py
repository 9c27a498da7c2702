"""What the engine refuses, as exceptions.

Each has the engine's own words: ``kind`` is a stable key, ``field`` what is at fault, ``message`` the sentence, ``hint`` what to do next. That there
is no path is an answer and raises nothing.
"""

from __future__ import annotations

__all__ = [
    "ArgumentError",
    "FileError",
    "FormatError",
    "FormicariumError",
    "FormicariumWarning",
    "MissingExtraError",
    "ParamError",
    "QuestionError",
    "ScenarioError",
]


class FormicariumError(Exception):
    """Anything that this package refuses."""

    kind: str
    field: str
    message: str
    hint: str

    def __init__(self, kind: str, field: str, message: str, hint: str) -> None:
        super().__init__(kind, field, message, hint)
        self.kind, self.field, self.message, self.hint = kind, field, message, hint

    def __str__(self) -> str:
        return f"{self.message} (hint: {self.hint})" if self.hint else self.message

    def __reduce__(self) -> tuple[type[FormicariumError], tuple[str, str, str, str]]:
        return type(self), (self.kind, self.field, self.message, self.hint)


class ArgumentError(FormicariumError, ValueError):
    """An argument of a function: its type, shape or values."""


class ParamError(FormicariumError, ValueError):
    """A planner, a preset or a parameter."""


class ScenarioError(FormicariumError, ValueError):
    """A map, its ends, or a quantity of it."""


class FormatError(FormicariumError, ValueError):
    """What a file holds."""


class QuestionError(FormicariumError, ValueError):
    """A question of a comparison."""


class FileError(FormicariumError, OSError):
    """A file that cannot be read or written; ``filename`` is its name."""

    def __init__(self, kind: str, field: str, message: str, hint: str) -> None:
        super().__init__(kind, field, message, hint)
        # What OSError makes of its arguments is meant for the system's errors.
        self.errno, self.strerror, self.filename, self.filename2 = None, message, field, None


class MissingExtraError(FormicariumError, ImportError):
    """An optional package that is not installed."""


class FormicariumWarning(UserWarning):
    """Something worth saying about an input that was accepted all the same; ``kind`` is a stable key."""

    kind: str
    message: str

    def __init__(self, message: str, kind: str = "note") -> None:
        super().__init__(message, kind)
        self.message, self.kind = message, kind

    def __str__(self) -> str:
        return self.message
