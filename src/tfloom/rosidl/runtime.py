"""The functions of `rosidl_runtime_py`: types by name."""

from __future__ import annotations

import importlib
from collections import OrderedDict
from typing import Any

from tfloom.rosidl.class_search import find_class
from tfloom.rosidl.definition import AbstractNestedType, AbstractType, NamespacedType, to_namespaced_type
from tfloom.rosidl.message import Message
from tfloom.rosidl.service import Action, Service


def get_interface(identifier: str) -> Any:
    """Return the class of a message, service or action by its full name.

    Raises:
        ValueError: the name has fewer than two parts, or an empty one.
        ModuleNotFoundError, AttributeError: as `import_message_from_namespaced_type`.
    """
    return import_message_from_namespaced_type(get_namespaced_type(identifier))


def get_message(identifier: str) -> type[Message]:
    """Return the class of a message: `geometry_msgs/msg/Twist`, or `geometry_msgs/Twist`.

    Raises:
        ValueError: the name has fewer than two parts, or an empty one, or is not a message's.
        ModuleNotFoundError, AttributeError: as `import_message_from_namespaced_type`.
    """
    found: type[Message] = _found(get_message_namespaced_type(identifier), Message, "a message", identifier)
    return found


def get_service(identifier: str) -> type[Service]:
    """Return the class of a service: `turtlesim/srv/Spawn`, or `turtlesim/Spawn`.

    Raises:
        ValueError, ModuleNotFoundError, AttributeError: as `get_message`.
    """
    found: type[Service] = _found(get_service_namespaced_type(identifier), Service, "a service", identifier)
    return found


def get_action(identifier: str) -> type[Action]:
    """Return the class of an action: `turtlesim/action/RotateAbsolute`, or `turtlesim/RotateAbsolute`.

    Raises:
        ValueError, ModuleNotFoundError, AttributeError: as `get_message`.
    """
    found: type[Action] = _found(get_action_namespaced_type(identifier), Action, "an action", identifier)
    return found


def _found(named: NamespacedType, base: type, word: str, identifier: str) -> Any:
    interface = import_message_from_namespaced_type(named)
    if not _is(interface, base):
        raise ValueError(f"Expected the full name of {word}, got '{identifier}'")
    return interface


def get_namespaced_type(identifier: str) -> NamespacedType:
    """Return a type name of at least two parts as a `NamespacedType`.

    Raises:
        ValueError: it has fewer parts, or an empty one.
    """
    parts = identifier.split("/")
    if len(parts) < 2:
        raise ValueError(f"Invalid name '{identifier}'. Expected at least two parts separated by '/'")
    if not all(parts):
        raise ValueError(f"Invalid name '{identifier}'. Must not contain empty parts")
    return to_namespaced_type(identifier)


def get_message_namespaced_type(identifier: str) -> NamespacedType:
    """Return a message's name as a `NamespacedType`, with `msg` inserted where it is missing.

    Raises:
        ValueError: it has fewer than two parts, or an empty one.
    """
    return _with_kind(identifier, "msg")


def get_service_namespaced_type(identifier: str) -> NamespacedType:
    """Return a service's name as a `NamespacedType`, with `srv` inserted where it is missing.

    Raises:
        ValueError: it has fewer than two parts, or an empty one.
    """
    return _with_kind(identifier, "srv")


def get_action_namespaced_type(identifier: str) -> NamespacedType:
    """Return an action's name as a `NamespacedType`, with `action` inserted where it is missing.

    Raises:
        ValueError: it has fewer than two parts, or an empty one.
    """
    return _with_kind(identifier, "action")


def _with_kind(identifier: str, kind: str) -> NamespacedType:
    named = get_namespaced_type(identifier)
    if len(named.namespaces) == 1:
        named.namespaces.append(kind)
    return named


def is_message(interface: object) -> bool:
    """Return whether an object is a message class or a message."""
    return _is(interface, Message)


def is_service(interface: object) -> bool:
    """Return whether an object is a service class."""
    return _is(interface, Service)


def is_action(interface: object) -> bool:
    """Return whether an object is an action class."""
    return _is(interface, Action)


def _is(interface: object, base: type) -> bool:
    return issubclass(interface if isinstance(interface, type) else type(interface), base)


def import_message_from_namespaced_type(message_type: NamespacedType | AbstractNestedType) -> Any:
    """Return the class of a message, a service or an action, or of a part of one; of an array, that of its elements.

    Raises:
        ModuleNotFoundError: there is no such package, or it has no interfaces of that kind.
        AttributeError: there is no such interface in it.
    """
    named: Any = message_type.value_type if isinstance(message_type, AbstractNestedType) else message_type
    *namespaces, base = named.namespaced_name()
    try:
        return find_class("/".join([*namespaces, base]))
    except LookupError:
        module = importlib.import_module(".".join(namespaces))
    return getattr(module, base)


def get_message_slot_types(msg: Message) -> OrderedDict[str, AbstractType]:
    """Return the type of each field, as an object of `rosidl_parser.definition`."""
    return OrderedDict(zip(msg._FIELDS, msg.SLOT_TYPES, strict=True))
