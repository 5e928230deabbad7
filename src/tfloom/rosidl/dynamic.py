"""Classes of types that no Python package holds, made at run time from their definitions.

    Custom = define("my_msgs/msg/Custom", "float64[<=3] ranges")
    classes = define_folder("my_ws/src/my_msgs")

Types of a sourced workspace need neither: `registry.get_message_class` finds their definitions.
"""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any

from tfloom.rosidl import registry, sources, spec
from tfloom.rosidl.message import Message
from tfloom.rosidl.parse import ParseError, parse_interface
from tfloom.rosidl.service import Action, Service
from tfloom.rosidl.type_hash import type_hash

LOCK = threading.RLock()
"""Held while classes are made."""


def define(name: str, text: str, path: str | None = None) -> Any:
    """Make the class of a definition and make it known by its name.

    Args:
        name: `package/kind/Name`; the kind (msg, srv or action) says how the text is read.
        text: What the definition file would hold.
        path: Where the text comes from, for errors.

    Returns:
        A subclass of `Message`, `Service` or `Action`.

    Raises:
        ParseError: the text is no definition, refers to a message that is not known, or contains itself.
        ValueError: `name` is no interface name.
    """
    parse_interface(text, name, path)
    with LOCK:
        return _define(name, text, path)


def _define(name: str, text: str, path: str | None) -> Any:
    before = sources.replace(name, sources.Source(text, path or f"{name}.{name.split('/')[1]}"))
    try:
        return load(name)
    except Exception:
        sources.replace(name, before)
        raise


def define_folder(folder: str | Path) -> dict[str, Any]:
    """Make the classes of all definitions in a package's folder, by name.

    Args:
        folder: Holds `msg`, `srv` and `action`, and is named as the package is.

    Raises:
        FileNotFoundError: the folder holds no definitions.
        ParseError: a definition can't be read, or refers to a message that is not known.
    """
    home = Path(folder).resolve()
    names = sources.names_in(home)
    if not names:
        raise FileNotFoundError(f"there are no definitions in {home}/{{{','.join(sources.KINDS)}}}")
    for name in names:
        _, kind, base = name.split("/")
        path = home / kind / f"{base}.{kind}"
        sources.replace(name, sources.Source(path.read_text(encoding="utf-8"), str(path)))
    with LOCK:
        return {name: load(name) for name in names}


def load(name: str) -> Any:
    """Make the classes of a definition that `sources` knows.

    Raises:
        LookupError: there is none of that name.
        ParseError: as `define`.
    """
    interface = sources.find_interface(name)
    _check_references(interface)
    registry.forget(name)
    parts = {part.name: _message_class(part) for part in _messages(interface)}
    for each in parts.values():
        registry.register(each)
    if isinstance(interface, spec.Message):
        return parts[name]
    made = (
        _service_class(interface, parts)
        if isinstance(interface, spec.Service)
        else _action_class(interface, parts)
    )
    registry.register(made)
    return made


def _messages(interface: spec.Interface) -> tuple[spec.Message, ...]:
    return (interface,) if isinstance(interface, spec.Message) else interface.messages


def _check_references(interface: spec.Interface) -> None:
    """Check that all messages referred to are known, and that none contains itself.

    Raises:
        ParseError: one is not known, or contains itself.
    """
    known = {message.name: message for message in _messages(interface)}

    def visit(message: spec.Message, above: tuple[str, ...]) -> None:
        for field in message.fields:
            if field.type.is_primitive:
                continue
            chain = (*above, message.name, field.type.base)
            if field.type.base in chain[:-1]:
                raise _at(message, field, f"a message contains itself: {' -> '.join(chain)}")
            try:
                nested = known.get(field.type.base) or sources.find_message(field.type.base)
            except LookupError as error:
                raise _at(message, field, str(error)) from None
            visit(nested, chain[:-1])

    for message in known.values():
        visit(message, ())


def _at(message: spec.Message, field: spec.Field, reason: str) -> ParseError:
    source = sources.find_source(sources.definition_name(message.name))
    return ParseError(source.path if source else message.name, *field.position, reason)


def _class(name: str, base: type, attributes: dict[str, Any]) -> Any:
    """Make a class that pickle finds again, by `__getattr__` below."""
    return type(
        name.rpartition("/")[2],
        (base,),
        {"__module__": __name__, "__qualname__": name, "_TYPE_NAME": name, **attributes},
    )


def _message_class(message: spec.Message) -> type[Message]:
    attributes: dict[str, Any] = {
        "__doc__": message.comment or f"The message {message.name}.",
        "__slots__": tuple(f"_{field.name}" for field in message.fields),
        "_TYPE_HASH": type_hash(message, sources.find_message),
        "_FIELDS": {field.name: str(field.type) for field in message.fields},
        "_DEFAULTS": {field.name: field.default for field in message.fields if field.default is not None},
        **{constant.name: constant.value for constant in message.constants},
    }
    made: type[Message] = _class(message.name, Message, attributes)
    return made


def _service_class(service: spec.Service, parts: dict[str, type[Message]]) -> type[Service]:
    made: type[Service] = _class(
        service.name,
        Service,
        {
            "_TYPE_HASH": type_hash(service, sources.find_message),
            "Request": parts[service.request.name],
            "Response": parts[service.response.name],
            "Event": parts[service.event.name],
        },
    )
    return made


def _action_class(action: spec.Action, parts: dict[str, type[Message]]) -> type[Action]:
    carriers = {
        "SendGoalService": _service_class(action.send_goal, parts),
        "GetResultService": _service_class(action.get_result, parts),
        "FeedbackMessage": parts[action.feedback_message.name],
        "CancelGoalService": registry.get_service_class("action_msgs/srv/CancelGoal"),
        "GoalStatusMessage": registry.get_message_class("action_msgs/msg/GoalStatusArray"),
    }
    made: type[Action] = _class(
        action.name,
        Action,
        {
            "_TYPE_HASH": type_hash(action, sources.find_message),
            "Goal": parts[action.goal.name],
            "Result": parts[action.result.name],
            "Feedback": parts[action.feedback.name],
            "Impl": type("Impl", (), {"__doc__": "What carries the action.", **carriers}),
        },
    )
    return made


def __getattr__(name: str) -> Any:
    """Give a class by its type's name: this is how pickle finds one."""
    if "/" not in name:
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
    try:
        return registry.find_class(name)
    except LookupError as error:
        raise AttributeError(str(error)) from None
