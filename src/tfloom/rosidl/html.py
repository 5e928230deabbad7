"""What a message shows in a notebook, as HTML: a table of its fields."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

__all__ = ["message_html"]

MAX_MESSAGES = 10
"""How many messages of a sequence are shown."""
MAX_NUMBERS = 20
MAX_CHARACTERS = 500


def message_html(message: Any) -> str:
    """Return a message as a table; messages in it are tables that can be folded."""
    return f"<b>{escape(message._TYPE_NAME)}</b>{_table(message)}"


def _table(message: Any) -> str:
    rows = "".join(
        f"<tr><th style='text-align:left'>{escape(name)}</th>"
        f"<td style='text-align:left'>{_value(getattr(message, name), kind)}</td></tr>"
        for name, kind in message._FIELDS.items()
    )
    return f"<table>{rows}</table>"


def _value(value: Any, kind: str) -> str:
    if hasattr(value, "_FIELDS"):
        return _folded(kind, _table(value), is_open=len(value._FIELDS) <= 4)
    if isinstance(value, str):
        shown = value[:MAX_CHARACTERS]
        return escape(shown) + ("…" if len(value) > MAX_CHARACTERS else "")
    if isinstance(value, Sequence) or hasattr(value, "tolist"):
        return _sequence(value, kind)
    return escape(str(value))


def _sequence(values: Any, kind: str) -> str:
    count = len(values)
    if count and hasattr(values[0], "_FIELDS"):
        shown = "".join(_table(item) for item in values[:MAX_MESSAGES])
        rest = f"{count - MAX_MESSAGES} more" if count > MAX_MESSAGES else ""
        return _folded(f"{kind}: {count}", shown + rest, is_open=count <= 1)
    shown = ", ".join(_number(number) for number in list(values[:MAX_NUMBERS]))
    return f"{count}: [{shown}{', …' if count > MAX_NUMBERS else ''}]"


def _number(value: Any) -> str:
    return escape(str(value.item() if hasattr(value, "item") else value)[:MAX_CHARACTERS])


def _folded(title: str, content: str, *, is_open: bool) -> str:
    return f"<details{' open' if is_open else ''}><summary>{escape(title)}</summary>{content}</details>"
