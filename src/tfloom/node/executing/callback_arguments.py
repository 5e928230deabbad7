"""Check of the number of arguments that a callback takes."""

from __future__ import annotations

from collections.abc import Callable
from types import FunctionType, MethodType
from typing import Any

__all__ = ["takes"]

_VAR_POSITIONAL = 0x04


def takes(callback: Callable[..., Any], count: int) -> bool:
    """Return whether `callback` can be called with `count` positional arguments; True if its signature is unknown."""
    function = callback.__func__ if isinstance(callback, MethodType) else callback
    if not isinstance(function, FunctionType) or hasattr(function, "__wrapped__"):
        return _binds(callback, count)
    code = function.__code__
    bound = 1 if isinstance(callback, MethodType) else 0
    most = code.co_argcount - bound
    least = most - len(function.__defaults__ or ())
    required_keywords = code.co_kwonlyargcount - len(function.__kwdefaults__ or ())
    return (
        least <= count and (count <= most or bool(code.co_flags & _VAR_POSITIONAL)) and required_keywords == 0
    )


def _binds(callback: Callable[..., Any], count: int) -> bool:
    from inspect import signature

    try:
        signature(callback).bind(*range(count))
    except TypeError:
        return False
    except ValueError:
        pass  # a built-in without a signature, as `print` before Python 3.11
    return True
