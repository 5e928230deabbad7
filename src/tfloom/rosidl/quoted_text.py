"""Texts of which it is known that they were in quotes."""

from __future__ import annotations

__all__ = ["QuotedText"]


class QuotedText(str):
    """A text that is in quotes in YAML, so it is one whatever ROS's rules read in a plain one."""

    __slots__ = ()
