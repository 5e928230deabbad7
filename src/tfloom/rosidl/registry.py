"""Interface types by name."""

from __future__ import annotations

import sys

from tfloom.rosidl.message import Message
from tfloom.rosidl.service import Action, Service

TYPE_CHECKING = False
if TYPE_CHECKING:
    from pathlib import Path
    from typing import Any, TypeVar

    T = TypeVar("T")


class UnknownTypeError(LookupError):
    """There is no interface of this name."""


_BASES = (Message, Service, Action)
_classes: dict[str, Any] = {}


def get_message_class(name: str) -> type[Message]:
    """Return the class of a message: `geometry_msgs/msg/Twist`, or `geometry_msgs/Twist` for short.

    Those of tfloom come first, then those of any importable package `package.msg`, then those whose definition is
    in a sourced workspace.

    Raises:
        LookupError: there is no such message, with the nearest name that there is.
        ParseError: its definition can't be read.
    """
    return _get(name, "msg", Message)


def get_service_class(name: str) -> type[Service]:
    """Return the class of a service: `turtlesim/srv/Spawn`, or `turtlesim/Spawn` for short.

    Raises:
        LookupError, ParseError: as `get_message_class`.
    """
    return _get(name, "srv", Service)


def get_action_class(name: str) -> type[Action]:
    """Return the class of an action: `turtlesim/action/RotateAbsolute`, or `turtlesim/RotateAbsolute` for short.

    Raises:
        LookupError, ParseError: as `get_message_class`.
    """
    return _get(name, "action", Action)


def find_class(name: str) -> Any:
    """Return the class of a message, service or action by its whole name.

    Raises:
        LookupError, ParseError: as `get_message_class`.
    """
    found = _classes.get(name)
    if found is None:
        found = _classes[name] = _find(name)
    return found


def register(cls: type[Any]) -> None:
    """Make a class known that no package holds, such as one made at run time."""
    _classes[cls._TYPE_NAME] = cls


def forget(name: str) -> None:
    """Drop what is known by a name, and by the names of its parts."""
    for known in [each for each in _classes if each == name or each.startswith(f"{name}_")]:
        del _classes[known]


def definitions_folder() -> Path:
    """Return where the definitions that come with tfloom are: `package/kind/Name.kind`."""
    from pathlib import Path

    return Path(__file__).parent / "definitions"


def interface_names(kind: str = "msg") -> list[str]:
    """Return the names of all interfaces of a kind (msg, srv, action) that come with tfloom, sorted."""
    return sorted(
        f"{path.parent.parent.name}/{kind}/{path.stem}"
        for path in definitions_folder().glob(f"*/{kind}/*.{kind}")
    )


def _get(name: str, kind: str, base: type[T]) -> type[T]:
    whole = name.replace("/", f"/{kind}/") if name.count("/") == 1 else name
    found: type[T] = find_class(whole)
    if issubclass(found, base):
        return found
    other = next(each for each in _BASES if issubclass(found, each))
    raise LookupError(f"'{name}' is no {base.__name__.lower()} type but a {other.__name__.lower()} type")


def _find(name: str) -> Any:
    parts = name.split("/")
    if len(parts) == 3 and all(part.isidentifier() for part in parts):
        package, kind, base = parts
        for module_name in (f"tfloom.interfaces.{package}.{kind}", f"{package}.{kind}"):
            found = getattr(_import(module_name), base, None)
            if isinstance(found, type) and issubclass(found, _BASES):
                return found
        found = _load_definition(name)
        if found is not None:
            return found
    raise UnknownTypeError(f"there is no {_word(parts)} type '{name}'{_nearest(name)}")


def _load_definition(name: str) -> Any:
    from tfloom.rosidl import dynamic, sources

    definition = sources.definition_name(name)
    if sources.find_source(definition) is None:
        return None
    if definition != name:  # a part of a class, which may be there: to load its definition would make another
        return _part(find_class(definition), name)
    with dynamic.LOCK:  # one class for all threads
        if name not in _classes:
            dynamic.load(definition)
        return _classes.get(name)


def _part(owner: type[Any], name: str) -> Any:
    """Return the class of this type name among the parts of a service or action, or None."""
    for each in vars(owner).values():
        if not isinstance(each, type) or each.__qualname__ == owner.__qualname__:
            continue
        if getattr(each, "_TYPE_NAME", None) == name:
            return each
        if (found := _part(each, name)) is not None:
            return found
    return None


def _import(module_name: str) -> Any:
    """Import a module, or give None if it or its package is not there. What fails inside it is raised."""
    try:
        __import__(module_name)
    except ModuleNotFoundError as error:
        if error.name is None or not module_name.startswith(error.name):
            raise
        return None
    return sys.modules[module_name]


def _word(parts: list[str]) -> str:
    return {"srv": "service", "action": "action"}.get(parts[1] if len(parts) == 3 else "", "message")


def _nearest(name: str) -> str:
    import difflib

    known = [each for kind in ("msg", "srv", "action") for each in interface_names(kind)]
    base = name.rpartition("/")[2]
    close = [each for each in known if each.endswith(f"/{base}")] or difflib.get_close_matches(name, known, 1)
    return f"; did you mean '{close[0]}'?" if close else ""
