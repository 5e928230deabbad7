"""Classes made at run time from the definitions that `sources` finds."""

from __future__ import annotations

import threading
from typing import Any

from tfloom.rosidl import class_table, sources, spec
from tfloom.rosidl.class_modules import module_of_made
from tfloom.rosidl.references import check_references
from tfloom.rosidl.service import Action, ActionImpl, Service
from tfloom.rosidl.type_hash import type_hash

LOCK = threading.RLock()
"""Held while classes are made."""

_HOME = "tfloom.rosidl.dynamic"
"""The module in which pickle looks up a class made here that has no module of its own."""


def load(name: str) -> Any:
    """Make the classes of a definition that `sources` finds.

    Raises:
        LookupError: there is no definition of that name.
        ParseError: it can't be parsed, refers to an unknown message, or contains itself.
    """
    interface = sources.find_interface(name)
    check_references(interface)
    class_table.forget(name)
    parts = {part.name: _message_class(part) for part in spec.messages_of(interface)}
    for part, cls in parts.items():
        class_table.register(part, cls)
    if isinstance(interface, spec.Message):
        return parts[name]
    made = (
        _service_class(interface, parts)
        if isinstance(interface, spec.Service)
        else _action_class(interface, parts)
    )
    class_table.register(name, made)
    return made


def _class(name: str, base: type, attributes: dict[str, Any]) -> Any:
    """Make a class that pickle can find, in the module of its definition or by `dynamic.__getattr__`."""
    class_name = name.rpartition("/")[2]
    module = module_of_made(sources.definition_name(name))
    place = {"__module__": _HOME, "__qualname__": name}
    if module is not None:
        place = {"__module__": module.__name__, "__qualname__": class_name}
    made = type(class_name, (base,), {**place, "_TYPE_NAME": name, **attributes})
    if module is not None:
        setattr(module, class_name, made)
    return made


def _message_class(message: spec.Message) -> Any:
    attributes: dict[str, Any] = {
        "__doc__": message.comment or f"The message {message.name}.",
        "__slots__": tuple(f"_{field.name}" for field in message.fields),
        "_TYPE_HASH": type_hash(message, sources.find_message),
        "_FIELDS": {field.name: str(field.type) for field in message.fields},
        "_DEFAULTS": {field.name: field.default for field in message.fields if field.default is not None},
        **{constant.name: constant.value for constant in message.constants},
    }
    return _class(message.name, class_table.message_base(), attributes)


def _service_class(service: spec.Service, parts: dict[str, Any]) -> type[Service]:
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


def _action_class(action: spec.Action, parts: dict[str, Any]) -> type[Action]:
    carriers = {
        "SendGoalService": _service_class(action.send_goal, parts),
        "GetResultService": _service_class(action.get_result, parts),
        "FeedbackMessage": parts[action.feedback_message.name],
        "CancelGoalService": class_table.find("action_msgs/srv/CancelGoal"),
        "GoalStatusMessage": class_table.find("action_msgs/msg/GoalStatusArray"),
    }
    made: type[Action] = _class(
        action.name,
        Action,
        {
            "_TYPE_HASH": type_hash(action, sources.find_message),
            "Goal": parts[action.goal.name],
            "Result": parts[action.result.name],
            "Feedback": parts[action.feedback.name],
            "Impl": type(
                "Impl",
                (ActionImpl,),
                {"__doc__": "The services and messages that carry the action.", **carriers},
            ),
        },
    )
    impl: Any = made.Impl
    impl.__module__, impl.__qualname__ = made.__module__, f"{made.__qualname__}.Impl"
    return made
