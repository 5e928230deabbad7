"""Selection of messages and of their fields, by a user's Python expressions and field paths."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import Any

from tfloom.cli.shared.errors import CommandError
from tfloom.rosidl.message import Message


def message_filter(expression: str | None) -> Callable[[Message], bool]:
    """Return a function that evaluates a Python expression for a message `m`; None: one that accepts all messages.

    Raises:
        CommandError: it isn't a Python expression; the function raises it if the evaluation fails.
    """
    if expression is None:
        return lambda _: True
    try:
        code = compile(expression, "--filter", "eval")
    except (SyntaxError, ValueError) as error:  # ValueError: a null byte, before Python 3.12
        reason = error.msg if isinstance(error, SyntaxError) else error
        raise CommandError(f"--filter isn't a Python expression: {reason}\n  {expression}") from None

    def accepts(message: Message) -> bool:
        try:
            return bool(eval(code, {"m": message}))  # noqa: S307  # the user's own expression, on their machine
        except Exception as error:  # noqa: BLE001  # a user's expression may raise anything
            fields = _there_are(error.obj) if isinstance(error, AttributeError) else ""
            raise CommandError(f"--filter failed: {type(error).__name__}: {error}{fields}") from None

    return accepts


def field_picker(paths: Sequence[str]) -> Callable[[Message], Any]:
    """Return the function that returns a message's field, `header.stamp` or `transforms[0].header`.

    Without a path it returns the whole message, with several a mapping of each path to its field.

    Raises:
        CommandError: one isn't a path; the function raises it if a message has no such field.
    """
    if not paths:
        return lambda message: message
    picks = {path: _one_field_picker(path) for path in paths}
    if len(picks) == 1:
        return picks[paths[0]]
    return lambda message: {path: pick(message) for path, pick in picks.items()}


def _one_field_picker(path: str) -> Callable[[Message], Any]:
    parts = [part for part in path.split(".") if part]
    if not parts:
        raise CommandError(
            f"Invalid field value '{path}'\n--field is like header.stamp or transforms[0].header"
        )
    steps = [step for part in parts for step in _steps(part)]

    def pick(message: Message) -> Any:
        value: Any = message
        try:
            for step in steps:
                value = value[step] if isinstance(step, int) else _field(value, step)
        except (AttributeError, IndexError, TypeError) as error:
            raise CommandError(f"Invalid field '{path}': {error}{_there_are(value)}") from None
        return value

    return pick


def _steps(part: str) -> list[str | int]:
    """Return a name and its indices, of `a[0]`; what has another form is a name that no field has."""
    if not re.fullmatch(r"\w+(\[-?\d+\])*", part):
        return [part]
    name, *indices = re.findall(r"\w+|-\d+", part)
    return [name, *map(int, indices)]


def _field(value: Any, name: str) -> Any:
    """Return a message's field; other attributes are not fields."""
    if isinstance(value, Message) and name not in type(value).get_fields_and_field_types():
        raise AttributeError(f"'{type(value).__name__}' object has no attribute '{name}'")
    return getattr(value, name)


def _there_are(value: Any) -> str:
    if not isinstance(value, Message):
        return ""
    return f"\nthere are: {', '.join(type(value).get_fields_and_field_types())}"
