"""The functions of `rosidl_runtime_py`: types by name, and lists of them."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterable
from typing import Any

from tfloom.rosidl import definition_files
from tfloom.rosidl.class_search import find_class
from tfloom.rosidl.definition import AbstractType, NamespacedType, to_namespaced_type
from tfloom.rosidl.message import Message
from tfloom.rosidl.registry import get_action_class, get_message_class, get_service_class
from tfloom.rosidl.service import Action, Service


def get_interface(identifier: str) -> Any:
    """Return the class of a message, service or action by its full name.

    Raises:
        ValueError: there is none.
    """
    get_namespaced_type(identifier)
    return _found(find_class, identifier)


def get_message(identifier: str) -> type[Message]:
    """Return the class of a message: `geometry_msgs/msg/Twist`, or `geometry_msgs/Twist`.

    Raises:
        ValueError: there is none.
    """
    return _found(get_message_class, identifier)  # type: ignore[no-any-return]


def get_service(identifier: str) -> type[Service]:
    """Return the class of a service: `turtlesim/srv/Spawn`, or `turtlesim/Spawn`.

    Raises:
        ValueError: there is none.
    """
    return _found(get_service_class, identifier)  # type: ignore[no-any-return]


def get_action(identifier: str) -> type[Action]:
    """Return the class of an action: `turtlesim/action/RotateAbsolute`, or `turtlesim/RotateAbsolute`.

    Raises:
        ValueError: there is none.
    """
    return _found(get_action_class, identifier)  # type: ignore[no-any-return]


def _found(find: Any, identifier: str) -> Any:
    try:
        return find(identifier)
    except LookupError as error:
        raise ValueError(str(error)) from None


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


def import_message_from_namespaced_type(message_type: NamespacedType) -> type[Message]:
    """Return the class of a message.

    Raises:
        ValueError: there is none.
    """
    return get_message("/".join(message_type.namespaced_name()))


def get_message_slot_types(msg: Message) -> OrderedDict[str, AbstractType]:
    """Return the type of each field, as an object of `rosidl_parser.definition`."""
    return OrderedDict(zip(msg._FIELDS, msg.SLOT_TYPES, strict=True))


def get_interface_packages() -> dict[str, str]:
    """Return the packages that have definitions, each with the folder of its definitions."""
    found: dict[str, str] = {}
    for share in definition_files.share_folders():
        for folder in sorted(share.glob("*/")):
            if folder.name not in found and definition_files.names_in(folder):
                found[folder.name] = str(share)
    return found


def get_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the interfaces of packages, or of all of them, as `kind/Name`, sorted.

    Raises:
        LookupError: a package is unknown.
    """
    packages = get_interface_packages()
    wanted = list(package_names) or sorted(packages)
    for name in wanted:
        if name not in packages:
            raise LookupError(f"Unknown package '{name}'")
    return {name: _names(packages[name], name) for name in wanted}


def get_message_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the messages of packages, or of all of them, as `msg/Name`; packages without any are omitted.

    Raises:
        LookupError: a package is unknown.
    """
    return _of_kind("msg", package_names)


def get_service_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the services of packages, or of all of them, as `srv/Name`; packages without any are omitted.

    Raises:
        LookupError: a package is unknown.
    """
    return _of_kind("srv", package_names)


def get_action_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the actions of packages, or of all of them, as `action/Name`; packages without any are omitted.

    Raises:
        LookupError: a package is unknown.
    """
    return _of_kind("action", package_names)


def get_interface_path(interface_name: str) -> str:
    """Return the file that defines `package/kind/Name`.

    Raises:
        LookupError: there is none.
    """
    path = definition_files.find_path(interface_name)
    if path is None:
        raise LookupError(f"Could not find the interface '{interface_name}'")
    return str(path)


def _names(share: str, package: str) -> list[str]:
    from pathlib import Path

    return [name.partition("/")[2] for name in definition_files.names_in(Path(share) / package)]


def _of_kind(kind: str, package_names: Iterable[str]) -> dict[str, list[str]]:
    found = {
        package: [name for name in names if name.startswith(f"{kind}/")]
        for package, names in get_interfaces(package_names).items()
    }
    return {package: names for package, names in found.items() if names}
