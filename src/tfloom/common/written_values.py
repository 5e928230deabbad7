"""Values of which it is known how they were written in YAML."""

from __future__ import annotations

from typing import Any, NamedTuple

__all__ = ["PlainValue", "QuotedText"]


class QuotedText(str):
    """A text that is in quotes in YAML, so it is one whatever ROS's rules read in a plain one."""

    __slots__ = ()


class PlainValue(NamedTuple):
    """A value without quotes that YAML takes for no text, as `off`: a field of a message may be one."""

    text: str
    """As it is written."""
    value: Any
    """By YAML's rules."""
