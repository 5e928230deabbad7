"""Numeric arrays of messages: `array.array` for sequences, numpy arrays for those of fixed length."""

from __future__ import annotations

from array import array
from typing import Any

from tfloom.rosidl.array_codes import ARRAY_CODES
from tfloom.rosidl.parse import parse_type
from tfloom.rosidl.spec import Type

# An integer of 8 bytes has two codes, depending on the platform: l and q.
_KINDS = {
    **dict.fromkeys("bhilq", "signed"),
    **dict.fromkeys("BHILQ", "unsigned"),
    **dict.fromkeys("fd", "float"),
}


def convert(type_text: str, value: Any) -> Any:
    """Convert a value that is assigned to a numeric array field to the array that the message holds.

    Args:
        type_text: The field's type, `float64[36]` or `uint8[]`.
        value: An array of the right type, which is returned unchanged, or any iterable of numbers.

    Returns:
        A numpy array or an `array.array` of the field's number type. The length is not checked.

    Raises:
        TypeError, ValueError, OverflowError: as numpy and `array.array` raise them.
    """
    type_ = parse_type(type_text)
    if type_.shape == "array":
        return _numpy_array(type_, value)
    code = ARRAY_CODES[type_.base]
    if isinstance(value, array) and value.typecode == code:
        return value
    return _from_memory(code, value) or array(code, value)


def _numpy_array(type_: Type, value: Any) -> Any:
    """Return a numpy array of the field's number type."""
    import numpy as np

    return np.asarray(value, ARRAY_CODES[type_.base])


def _from_memory(code: str, value: Any) -> array[Any] | None:
    """Copy a buffer of the same number type, such as a numpy image, at once; None for any other value."""
    try:
        view = memoryview(value)
    except TypeError:
        return None
    result = array(code)
    same_numbers = _KINDS.get(view.format) == _KINDS[code] and view.itemsize == result.itemsize
    if not same_numbers or not view.c_contiguous:
        return None
    result.frombytes(view.cast("B") if view.nbytes else b"")
    return result
