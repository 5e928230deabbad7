"""Texts of types: a field's type as message classes spell it, and the names of each number type in array and numpy."""

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


ARRAY_CODES = {
    "int8": "b",
    "uint8": "B",
    "char": "B",
    "int16": "h",
    "uint16": "H",
    "int32": "i",
    "uint32": "I",
    "int64": "q",
    "uint64": "Q",
    "float32": "f",
    "float64": "d",
}
NUMPY_NAMES = {base: "uint8" if base == "char" else base for base in ARRAY_CODES}
"""Not the codes: numpy prints `q`, of 8 bytes as `l`, as another type than `int64`."""
