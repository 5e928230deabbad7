"""The names of each number type in `array.array` and in numpy."""

from __future__ import annotations

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
