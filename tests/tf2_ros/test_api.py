"""The public names of ROS 2 Jazzy's tf2 packages exist, and take the same arguments in the same order."""

from __future__ import annotations

import importlib
import inspect
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import tf2_py
import tf2_ros
from tests.each import for_each

from tfloom.tf2_ros import buffer, transform_listener

GOLDEN = Path(__file__).parents[1] / "golden" / "api_tf2.json"
API: dict[str, dict[str, Any]] = json.loads(GOLDEN.read_text("utf-8"))


def recorded(signature: str) -> list[tuple[str, str | None]]:
    """Return each parameter's name, with its stars, and its default as text."""
    inside = signature[1 : signature.rindex(") ->" if ") ->" in signature else ")")]
    parts, depth = [""], 0
    for character in inside:
        depth += (character in "[(") - (character in "])")
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    found = []
    for part in filter(None, map(str.strip, parts)):
        name = re.match(r"\**\w*", part)[0]
        default = re.search(r" = (.*)$" if part[len(name) :].startswith(":") else r"=(.*)$", part)
        found.append((name, default and default[1].replace('"', "'")))
    return found


def ours(function: object) -> list[tuple[str, str | None]]:
    found = []
    is_named_only = False
    for parameter in inspect.signature(function).parameters.values():
        if parameter.kind is parameter.KEYWORD_ONLY and not is_named_only:
            is_named_only = True
            found.append(("*", None))
        stars = {parameter.VAR_POSITIONAL: "*", parameter.VAR_KEYWORD: "**"}.get(parameter.kind, "")
        found.append(
            (
                stars + parameter.name,
                None if parameter.default is parameter.empty else repr(parameter.default),
            )
        )
    return found


def calls() -> Iterator[tuple[str, str]]:
    """Each function, method and constructor, as dotted names from the module on, and its signature."""
    for module, names in API.items():
        for name, what in names.items():
            if what["kind"] == "function":
                yield f"{module}:{name}", what["signature"]
            elif what["kind"] == "class":
                if what["init"] is not None:
                    yield f"{module}:{name}.__init__", what["init"]
                for member, signature in what["members"].items():
                    yield f"{module}:{name}.{member}", signature


def find(place: str) -> Any:
    module, _, path = place.partition(":")
    found = importlib.import_module(module)
    for name in path.split("."):
        found = getattr(found, name)
    return found


CALLS = dict(calls())


@for_each(CALLS)
def test_signatures_accept_the_arguments_of_the_reference(place: str) -> None:
    theirs, mine = recorded(CALLS[place]), ours(find(place))
    names = [name for name, _ in theirs]
    assert [name for name, _ in mine if name in names] == names
    defaults = dict(mine)
    assert {name: defaults[name] for name, default in theirs if default is not None} == {
        name: default for name, default in theirs if default is not None
    }
    # Additional optional arguments are allowed.
    assert all(default is not None or name == "*" for name, default in mine if name not in names)


def test_classes_have_the_same_bases() -> None:
    checked = 0
    for module, names in API.items():
        for name, what in names.items():
            if what["kind"] != "class":
                continue
            kinds = {kind.__name__ for kind in find(f"{module}:{name}").__mro__}
            assert set(what["bases"]) <= kinds, (module, name)
            checked += 1
    assert checked > 20


def test_recording_is_complete() -> None:
    assert len(CALLS) > 130
    assert recorded('(a: X[b, c] = Duration(nanoseconds=0), *, d="unsafe") -> None') == [
        ("a", "Duration(nanoseconds=0)"), ("*", None), ("d", "'unsafe'")
    ]  # fmt: skip


def test_submodules_are_imported_with_the_package() -> None:
    assert tf2_ros.buffer.Buffer is tf2_ros.Buffer is buffer.Buffer
    assert tf2_ros.transform_listener.TransformListener is transform_listener.TransformListener
    assert tf2_ros.static_transform_listener.StaticTransformListener is tf2_ros.StaticTransformListener
    assert (tf2_ros.transform_listener.DEFAULT_TF_TOPIC, tf2_ros.DEFAULT_STATIC_TF_TOPIC) == (
        "/tf",
        "/tf_static",
    )


def test_exceptions_have_a_common_base() -> None:
    assert tf2_ros.LookupException is tf2_py.LookupException
    assert tf2_py.LookupException.__module__ == "tf2"
    assert issubclass(tf2_ros.ExtrapolationException, tf2_ros.TransformException)
    assert issubclass(tf2_ros.Buffer, tf2_py.BufferCore)


def test_names_leaked_by_the_reference_exist() -> None:
    assert all(hasattr(tf2_ros, name) for name in ("Time", "Duration", "TransformStamped", "Header"))
