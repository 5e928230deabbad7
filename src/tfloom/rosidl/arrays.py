"""Numeric arrays of messages: `array.array` for sequences, numpy arrays for those of fixed length."""

from __future__ import annotations

import math
from array import array
from typing import Any

from tfloom.rosidl.parse import parse_type
from tfloom.rosidl.spec import Type
from tfloom.rosidl.type_text import ARRAY_CODES, NUMPY_NAMES

# An integer of 8 bytes has two codes, depending on the platform: l and q.
_KINDS = {
    **dict.fromkeys("bhilq", "signed"),
    **dict.fromkeys("BHILQ", "unsigned"),
    **dict.fromkeys("fd", "float"),
}


BEYOND_FLOAT32 = "a number is beyond the range of float32"


def convert(type_text: str, value: Any) -> Any:
    """Convert a value that is assigned to a numeric array field to the array that the message holds.

    Args:
        type_text: The field's type, `float64[36]` or `uint8[]`.
        value: An array of the right type, which is returned unchanged, or any iterable of numbers.

    Returns:
        A numpy array or an `array.array` of the field's number type. The length is not checked.

    Raises:
        TypeError, ValueError, OverflowError: as numpy and `array.array` raise them; or a number is not one of the
            field's type, as 1e50 of float32 and 300 of uint8.
    """
    type_ = parse_type(type_text)
    if type_.shape == "array":
        return _numpy_array(type_, value)
    code = ARRAY_CODES[type_.base]
    if isinstance(value, array) and value.typecode == code:
        return value
    copied = _from_memory(code, value)
    if copied is not None:
        return copied
    if code == "f" and not hasattr(value, "__len__"):
        value = list(value)  # to be read twice
    result = array(code, value)
    # `array` makes a number beyond float32 infinite, without an error. The sum is finite if all numbers are.
    if code == "f" and not math.isfinite(sum(result)) and not isinstance(value, (bytes, bytearray)):
        for stored, number in zip(result, value, strict=True):
            if math.isinf(stored) and not math.isinf(number):
                raise OverflowError(BEYOND_FLOAT32)
    return result


def _numpy_array(type_: Type, value: Any) -> Any:
    """Return a numpy array of the field's number type."""
    import numpy as np

    name = NUMPY_NAMES[type_.base]
    given = np.asarray(value)
    if given.dtype == name:
        return np.asarray(given, name)  # numpy has a second type of these bytes, with its own repr
    # numpy wraps, truncates or makes infinite what the type can't hold, without an error.
    with np.errstate(over="ignore", invalid="ignore"):
        result = np.asarray(value, name)
    if name == "float32":
        if (np.isinf(result) & ~np.isinf(np.asarray(value, "float64"))).any():
            raise OverflowError(BEYOND_FLOAT32)
    elif name != "float64" and given.dtype.kind in "iuf" and (result != given).any():
        error = ValueError if given.dtype.kind == "f" else OverflowError
        raise error(f"a number is not one of {type_.base}")
    return result


def are_equal(ours: Any, theirs: Any) -> bool:
    """Return whether two values of a field, one of which is an array of numpy, have the same elements."""
    if hasattr(ours, "shape") and hasattr(theirs, "shape"):
        return bool(ours.shape == theirs.shape and (ours == theirs).all())
    # The other one is a list, as a received message has it, or a single value.
    first, second = (
        value.tolist() if hasattr(value, "tolist") else list(value) if isinstance(value, tuple) else value
        for value in (ours, theirs)
    )
    return bool(first == second)


def _from_memory(code: str, value: Any) -> array[Any] | None:
    """Copy a buffer of the same number type, such as a numpy image, at once; None for any other value."""
    try:
        view = memoryview(value)
    except TypeError:
        return None
    result = array(code)
    if view.ndim == 0:  # a single number of numpy, which is not a sequence
        return None
    same_numbers = _KINDS.get(view.format) == _KINDS[code] and view.itemsize == result.itemsize
    if not same_numbers or not view.c_contiguous:
        return None
    result.frombytes(view.cast("B") if view.nbytes else b"")
    return result
