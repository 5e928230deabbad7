"""Parsing of a field's type as message classes spell it: `float64[36]`, `geometry_msgs/msg/Point[<=5]`."""

from __future__ import annotations


def split_type(text: str) -> tuple[str, int, str, int]:
    """Split a type into base, string bound, shape (``, `array`, `bounded`, `unbounded`) and length.

    The text must be one that `spec.Type` writes; it is not checked.
    """
    element, bracket, rest = text.partition("[")
    base, _, bound = element.partition("<=")
    shape, length = "", 0
    if bracket:
        digits = rest[:-1].removeprefix("<=")
        shape = "bounded" if rest[0] == "<" else "array" if digits else "unbounded"
        length = int(digits or 0)
    return base, int(bound or 0), shape, length
