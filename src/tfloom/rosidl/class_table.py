"""The table of interface classes by type name, which all other modules about classes import.

`message` passes its base class to `set_message_base` instead of being imported here: the first use of a message class
compiles its fields, which may make another class from a definition, so `message` itself imports the class factory.
"""

from __future__ import annotations

import sys

from tfloom._native import MessageBase
from tfloom.rosidl.service import Action, Service

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, ClassVar, Protocol

    from tfloom._native import Plan
    from tfloom.rosidl.spec import Value

    class MessageClass(Protocol):
        """The attributes of a message class that describe its type; `message.Message` documents each."""

        _TYPE_NAME: ClassVar[str]
        _FIELDS: ClassVar[dict[str, str]]
        _DEFAULTS: ClassVar[dict[str, Value]]
        _PLAN: ClassVar[Plan | None]


_OWN_HOMES = ("tfloom.interfaces.", "tfloom_interfaces.interfaces.")
"""The packages in which the interface packages of tfloom's definitions are."""
_classes: dict[str, Any] = {}
_bases: dict[str, type[Any]] = {"msg": MessageBase}


def set_message_base(cls: type[Any]) -> None:
    """Set the base of message classes made at run time."""
    _bases["msg"] = cls


def message_base() -> type[Any]:
    """Return the base of message classes made at run time."""
    return _bases["msg"]


def register(name: str, cls: type[Any]) -> None:
    """Add a class to the table under a name."""
    _classes[name] = cls


def registered(name: str) -> Any:
    """Return the class in the table under a name, or None."""
    return _classes.get(name)


def has_package(package: str) -> bool:
    """Return whether the table has a class of a package."""
    return any(class_name.startswith(f"{package}/") for class_name in _classes)


def forget(name: str) -> None:
    """Remove the class of a name, and those of its parts."""
    for known in [
        class_name for class_name in _classes if class_name == name or class_name.startswith(f"{name}_")
    ]:
        del _classes[known]


def find(name: str) -> Any:
    """Return the class of `package/kind/Name` from the table or from a Python module, or None.

    Modules are `tfloom.interfaces.package.kind`, that of the distribution `tfloom-interfaces`, and `package.kind`, in
    this order.
    """
    interface_class = _classes.get(name)
    if interface_class is None:
        interface_class = _find_in_modules(name)
        if interface_class is not None:
            _classes[name] = interface_class
    return interface_class


def find_own(name: str) -> Any:
    """Return tfloom's class of `package/kind/Name`, or that of `tfloom-interfaces`, or None."""
    return _find_in_modules(name, _OWN_HOMES)


def _find_in_modules(name: str, homes: tuple[str, ...] = (*_OWN_HOMES, "")) -> Any:
    parts = name.split("/")
    if len(parts) != 3 or not all(part.isidentifier() for part in parts):
        return None
    package, kind, base = parts
    for home in homes:
        module_name = f"{home}{package}.{kind}"
        attribute = getattr(_import(module_name), base, None)
        if isinstance(attribute, type) and issubclass(attribute, (MessageBase, Service, Action)):
            return attribute
    return None


def _import(module_name: str) -> Any:
    """Import a module; return None if it or its package is missing. Errors inside the module are raised."""
    try:
        __import__(module_name)
    except ModuleNotFoundError as error:
        if error.name is None or not module_name.startswith(error.name):
            raise
        return None
    return sys.modules[module_name]
