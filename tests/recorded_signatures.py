"""The differences between tfloom's names and the recorded ones: what is missing, and which signatures differ."""

from __future__ import annotations

import importlib
import inspect
import json
import re
from collections.abc import Iterator
from enum import Enum
from typing import Any

from tools.facades.recorded import Name, Parameter, parameters_of

_COMPILED = re.compile(r"rclpy\._rclpy_pybind11\b.*|_?tf2")
"""The compiled modules of rclpy and tf2_py, which programs do not import."""


def differences(name: Name) -> Iterator[str]:
    """Return the differences between tfloom's name and the recorded one; none if they are compatible."""
    try:
        owner: Any = importlib.import_module(name.module)
    except ModuleNotFoundError:
        yield "the module does not exist"
        return
    first, _, member = name.path.partition(".")
    if not hasattr(owner, first):
        yield "it does not exist"
        return
    thing = getattr(owner, first)
    if name.kind == "import":
        yield from _home_differences(thing, name)
    elif member:
        yield from _member_differences(thing, member, name)
    elif name.kind == "class":
        if not isinstance(thing, type):
            yield f"it is no class, but {thing!r}"
        elif name.signature:
            yield from signature_differences(name.signature, thing.__init__)
    elif name.kind == "function":
        yield from signature_differences(name.signature, thing)


def _home_differences(thing: Any, name: Name) -> Iterator[str]:
    """Compare with the object in the public module of its home: `geometry_msgs.msg` for `geometry_msgs.msg._pose`."""
    if not name.signature or _COMPILED.fullmatch(name.signature):
        return
    home = name.signature.partition("._")[0]
    if getattr(importlib.import_module(home), thing.__name__, None) is not thing:
        yield f"it is {thing!r}, not the object of {home}"


def _member_differences(owner: type, member: str, name: Name) -> Iterator[str]:
    if name.kind == "constant":
        value = getattr(owner, member, None)
        if value is None or repr(getattr(value, "value", value)) != name.signature:
            yield f"it is {value}, not {name.signature}"
        return
    if name.kind != "method":
        if not hasattr(owner, member) and not _instances_have(owner, member):
            yield "it does not exist"
        return
    if not hasattr(owner, member):
        yield "it does not exist"
    elif not callable(getattr(owner, member)):
        yield "it is not callable"
    elif not isinstance(getattr(owner, member), type):
        static = inspect.getattr_static(owner, member)
        yield from signature_differences(name.signature, getattr(static, "__func__", static))


def _instances_have(owner: type, member: str) -> bool:
    if issubclass(owner, Enum):
        return hasattr(next(iter(owner)), member)
    for cls in owner.__mro__:
        if member in cls.__dict__.get("__slots__", ()) or member in inspect.get_annotations(cls):
            return True
        code = getattr(cls.__dict__.get("__init__"), "__code__", None)
        if code is not None and member in code.co_names:
            return True
    return False


def signature_differences(signature: str, function: Any) -> Iterator[str]:
    try:
        ours = _our_parameters(function)
    except ValueError:  # a compiled function without a signature
        return
    theirs = parameters_of(signature)
    takes_anything = any(parameter.kind == "variable" for parameter in ours)
    by_name = {parameter.name: parameter for parameter in ours}
    for expected in theirs:
        if expected.kind == "variable":
            continue
        ours_of_name = by_name.get(expected.name)
        if ours_of_name is None:
            if not takes_anything:
                yield f"it has no parameter {expected.name}"
        elif ours_of_name.kind != expected.kind:
            yield f"its parameter {expected.name} is {ours_of_name.kind}, not {expected.kind}"
        elif expected.default is not None and _differ(ours_of_name, expected):
            yield f"the default of {expected.name} is {ours_of_name.default}, not {expected.default}"
    order = [parameter.name for parameter in theirs if parameter.kind == "positional"]
    if (
        order != [parameter.name for parameter in ours if parameter.kind == "positional"][: len(order)]
        and not takes_anything
    ):
        yield f"its parameters are not in the order {', '.join(order)}"
    recorded_names = {parameter.name for parameter in theirs}
    if "*args" not in recorded_names:
        yield from (
            f"it requires a parameter {parameter.name} that the recorded one lacks"
            for parameter in ours
            if parameter.name not in recorded_names
            and parameter.default is None
            and parameter.kind != "variable"
        )


def _our_parameters(function: Any) -> list[Parameter]:
    kinds = {
        inspect.Parameter.POSITIONAL_OR_KEYWORD: "positional",
        inspect.Parameter.POSITIONAL_ONLY: "positional",
        inspect.Parameter.KEYWORD_ONLY: "keyword",
    }
    return [
        Parameter(
            parameter.name,
            kinds.get(parameter.kind, "variable"),
            None if parameter.default is inspect.Parameter.empty else repr(parameter.default),
        )
        for parameter in inspect.signature(function).parameters.values()
        if parameter.name not in {"self", "cls"}
    ]


def _differ(found: Parameter, expected: Parameter) -> bool:
    """Return whether two defaults differ; False if one of the texts is not a literal."""
    if found.default is None:
        return True
    try:
        ours, theirs = (json.loads(_as_json(text or "")) for text in (found.default, expected.default))
    except ValueError:
        return False
    return bool(ours != theirs)


def _as_json(text: str) -> str:
    # An empty tuple counts as an empty list, because neither is changed.
    words = {"None": "null", "True": "true", "False": "false", "()": "[]"}
    return words.get(text, text.replace("'", '"'))
