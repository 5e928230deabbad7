"""The checks of `check_fields=True`, with the reference's texts."""

from __future__ import annotations

import math
import warnings
from array import array
from collections import UserString
from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from typing import Any

from tfloom.rosidl import spec
from tfloom.rosidl.class_search import find_field_class
from tfloom.rosidl.parse import parse_type
from tfloom.rosidl.type_text import ARRAY_CODES, NUMPY_NAMES

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.rosidl.class_table import MessageClass

# The largest finite numbers, in the reference's spelling.
_FLOAT_LIMITS = {"float32": ("float", "3.402823466e+38"), "float64": ("double", "1.7976931348623157e+308")}

_warned: set[tuple[type[MessageClass], str]] = set()
"""The keywords that `warn_of_unknown_names` has warned of, by class. Changed by single operations."""


def check_names(cls: type[MessageClass], kwargs: dict[str, object]) -> None:
    """Check that all keywords are fields of the class.

    Raises:
        AssertionError: some are not; the text lists them.
    """
    unknown = sorted(name for name in kwargs if name not in cls._FIELDS and name != "check_fields")
    if unknown:
        raise AssertionError(f"Invalid arguments passed to constructor: {', '.join(unknown)}")


def warn_of_unknown_names(cls: type[MessageClass], kwargs: dict[str, object]) -> None:
    """Warn of keywords that are not fields of the class and are therefore ignored, of each once.

    To be called by the constructor of the class, so that the warning names the line that calls this. No warning follows
    where `check_fields=False` says that none is wanted.
    """
    if kwargs.get("check_fields") is False:
        return
    for name in kwargs:
        if name in cls._FIELDS or name == "check_fields" or (cls, name) in _warned:
            continue
        _warned.add((cls, name))
        fields = f"its fields are {', '.join(cls._FIELDS)}" if cls._FIELDS else "it has no fields"
        warnings.warn(
            f"{cls._TYPE_NAME} has no field '{name}', so this keyword is ignored; {fields}", stacklevel=3
        )


def check_field(cls: type[MessageClass], name: str, value: Any) -> None:
    """Check the value of a field; ignore a name that is not a field.

    Raises:
        AssertionError: the value does not fit.
    """
    text = cls._FIELDS.get(name)
    if text is None:
        return
    type_ = parse_type(text)
    is_numeric = bool(type_.shape) and type_.base in ARRAY_CODES
    if is_numeric and type_.shape == "array" and hasattr(value, "dtype"):
        reason = _numpy_mismatch(type_, value)
    elif is_numeric and type_.shape != "array" and isinstance(value, array):
        reason = _array_mismatch(type_, value)
    elif type_.shape:
        reason = "" if _is_sequence_of(type_, value) else _describe_sequence(type_)
    else:
        reason = _mismatch(type_, value)
    if reason:
        raise AssertionError(f"The '{name}' {reason}")


def _numpy_mismatch(type_: spec.Type, value: Any) -> str:
    dtype = NUMPY_NAMES[type_.base]
    if value.dtype != dtype:
        return f"numpy.ndarray() must have the dtype of 'numpy.{dtype}'"
    return f"numpy.ndarray() must have a size of {type_.length}" if value.size != type_.length else ""


def _array_mismatch(type_: spec.Type, value: array[Any]) -> str:
    code = ARRAY_CODES[type_.base]
    if value.typecode != code:
        return f"array.array() must have the type code of '{code}'"
    if type_.shape == "bounded" and len(value) > type_.length:
        return f"array.array() must have a size <= {type_.length}"
    return ""


def _mismatch(type_: spec.Type, value: Any) -> str:
    """Return why a single value does not fit; an empty string if it does."""
    base = type_.base
    wanted: type[Any] = {"bool": bool, "string": str, "wstring": str, "float32": float, "float64": float}.get(
        base, int
    )
    if base == "byte":
        fits = isinstance(value, (bytes, bytearray)) and len(value) == 1
        return "" if fits else "field must be of type 'bytes' or 'ByteString' with length 1"
    if not type_.is_primitive:
        cls = find_field_class(base)
        return "" if isinstance(value, cls) else f"field must be a sub message of type '{cls.__name__}'"
    if not isinstance(value, wanted):
        return f"field must be of type '{wanted.__name__}'"
    if type_.string_bound and len(value) > type_.string_bound:
        return f"field must be string value not longer than {type_.string_bound}"
    return "" if _in_range(base, value) else f"field must be {_describe_range(base)}"


def _in_range(base: str, value: Any) -> bool:
    if base == "float32":
        return not math.isfinite(value) or abs(value) <= float(_FLOAT_LIMITS[base][1])
    if base in spec.INTEGER_RANGES:
        least, greatest = spec.INTEGER_RANGES[base]
        return bool(least <= value <= greatest)
    return True


def _describe_range(base: str) -> str:
    if base in _FLOAT_LIMITS:
        word, limit = _FLOAT_LIMITS[base]
        return f"a {word} in [-{limit}, {limit}]"
    least, greatest = spec.INTEGER_RANGES[base]
    return f"an {'unsigned ' if least == 0 else ''}integer in [{least}, {greatest}]"


def _is_sequence_of(type_: spec.Type, value: Any) -> bool:
    if not isinstance(value, (Sequence, AbstractSet)) or isinstance(value, (str, UserString)):
        return False
    if type_.shape == "array" and len(value) != type_.length:
        return False
    if type_.shape == "bounded" and len(value) > type_.length:
        return False
    if type_.base == "byte" and any(isinstance(element, bytearray) for element in value):
        return False
    return not any(_mismatch(type_.element, element) for element in value)


def _describe_sequence(type_: spec.Type) -> str:
    length = {"array": f" with length {type_.length}", "bounded": f" with length <= {type_.length}"}
    return (
        f"field must be a set or sequence{length.get(type_.shape, '')} and each value of {_describe(type_)}"
    )


def _describe(type_: spec.Type) -> str:
    names = {"bool": "bool", "byte": "bytes", "string": "str", "wstring": "str"}
    if not type_.is_primitive:
        return f"type '{type_.base.rpartition('/')[2]}'"
    if type_.base in names:
        return f"type '{names[type_.base]}'"
    kind = "float" if type_.base in spec.FLOATS else "int"
    return f"type '{kind}' and each {_describe_range(type_.base).partition(' ')[2]}"
