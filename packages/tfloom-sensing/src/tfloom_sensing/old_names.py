"""The deprecated names of image_geometry in Jazzy, each with a warning that names the replacement."""

from __future__ import annotations

import functools
import warnings
from collections.abc import Callable
from typing import Any, ParamSpec, TypeVar

import numpy as np

__all__ = ["old_matrix", "old_name", "old_property", "old_value"]

_Arguments = ParamSpec("_Arguments")
_Result = TypeVar("_Result")

_RELEASE = "J-turtle"
_NOT_EXPOSED = "It is not meant to be an exposed member."


def _warn(name: str, what: str, advice: str) -> None:
    reason = f"The {what} is deprecated as of {_RELEASE}, and will be removed in K-turtle. {advice}"
    warnings.warn(
        f"Call to deprecated method {name}. ({reason}) -- Deprecated since version {_RELEASE}.",
        DeprecationWarning,
        stacklevel=3,
    )


def old_name(name: str, new: Callable[_Arguments, _Result]) -> Callable[_Arguments, _Result]:
    """Return a method under its deprecated name."""

    @functools.wraps(new)
    def method(*args: _Arguments.args, **kwargs: _Arguments.kwargs) -> _Result:
        _warn(name, f"{name}() method", f"Please use the {new.__name__}() method instead.")
        return new(*args, **kwargs)

    method.__name__ = name
    return method


def old_matrix(name: str, new: Callable[[Any], Any]) -> Callable[[Any], np.matrix[Any, Any]]:
    """Return a method under its deprecated name, with a numpy.matrix as result."""

    def method(self: Any) -> np.matrix[Any, Any]:
        _warn(
            name,
            f"{name}()->numpy.matrix method",
            f"Please use the {new.__name__}()->numpy.ndarray method instead.",
        )
        return np.matrix(new(self), dtype=np.float64)

    method.__name__ = name
    method.__doc__ = new.__doc__
    return method


def old_value(name: str, attribute: str, advice: str = _NOT_EXPOSED) -> property:
    """Return a property that reads an attribute."""

    def get(self: Any) -> Any:
        _warn(name, f"{name} property", advice)
        return getattr(self, attribute)

    return property(get)


def old_property(name: str, new: Callable[[Any], Any]) -> property:
    """Return a property whose value is a method's result, as a numpy.matrix."""

    def get(self: Any) -> np.matrix[Any, Any]:
        _warn(
            name,
            f"{name}->numpy.matrix property",
            f"Please use the {new.__name__}()->numpy.ndarray method instead.",
        )
        return np.matrix(new(self), dtype=np.float64)

    return property(get)
