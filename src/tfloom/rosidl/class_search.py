"""The class of a type name: from the table, from a Python module, or made from a definition."""

from __future__ import annotations

from tfloom.rosidl import class_table
from tfloom.rosidl.service import Action, Service

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, TypeVar

    T = TypeVar("T")


class UnknownTypeError(LookupError):
    """There is no interface of a name, the one argument.

    The text has the nearest name that exists. It is made when it is asked for, because a caller that catches this
    error to look elsewhere would wait for the search through all definitions in vain.
    """

    def __str__(self) -> str:
        (name,) = self.args
        return f"there is no {_kind_word(name)} type '{name}'{_nearest_name_hint(name)}"


def find_class(name: str) -> Any:
    """Return the class of a message, service or action by its full name.

    Raises:
        LookupError: there is none; the text has the nearest name that exists.
        ParseError: its definition can't be parsed.
    """
    interface_class = find_known_class(name)
    if interface_class is None:
        raise UnknownTypeError(name)
    return interface_class


def find_known_class(name: str) -> Any:
    """Return the class of a full name, or None where there is none; without the search for the nearest name.

    Raises:
        ParseError: its definition can't be parsed.
    """
    interface_class = class_table.find(name)
    if interface_class is None:
        interface_class = find_by_definition(name)
        if interface_class is not None:
            class_table.register(name, interface_class)
    return interface_class


def full_name(name: str, kind: str) -> str:
    """Return `package/kind/Name` for `package/Name`; return any other name unchanged."""
    return name.replace("/", f"/{kind}/") if name.count("/") == 1 else name


def find_class_of_kind(name: str, kind: str, base: type[T]) -> type[T]:
    """Return the class of `package/kind/Name`, or of `package/Name` for short.

    Args:
        name: The type's name.
        kind: The part that a short name omits: msg, srv or action.
        base: The base class of this kind.

    Raises:
        LookupError: there is none, or it is of another kind.
        ParseError: its definition can't be parsed.
    """
    interface_class: type[T] = find_class(full_name(name, kind))
    if issubclass(interface_class, base):
        return interface_class
    other = next(
        base_class
        for base_class in (class_table.message_base(), Service, Action)
        if issubclass(interface_class, base_class)
    )
    raise LookupError(f"'{name}' is no {base.__name__.lower()} type but a {other.__name__.lower()} type")


def find_field_class(name: str) -> type[Any]:
    """Return the class of a field's type that is a message.

    Raises:
        LookupError, ParseError: as `find_class_of_kind`.
    """
    return find_class_of_kind(name, "msg", class_table.message_base())


def find_by_definition(name: str) -> Any:
    """Return the class of a whole name as its definition says, or None where there is no definition.

    Raises:
        ParseError: the definition can't be parsed, or refers to an unknown message.
    """
    if (registered_class := class_table.registered(name)) is not None:
        return registered_class
    parts = name.split("/")
    if len(parts) != 3 or not all(part.isidentifier() for part in parts):
        return None

    from tfloom.rosidl import class_factory, sources

    definition = sources.definition_name(name)
    if sources.find_source(definition) is None:
        return None
    if (
        definition != name
    ):  # it may be a part of an existing class, of which loading the definition would make a second one
        return _find_part(find_class(definition), name)
    with class_factory.LOCK:  # one class for all threads
        if class_table.registered(name) is None:
            class_factory.load(definition)
        return class_table.registered(name)


def _find_part(owner: type[Any], name: str) -> Any:
    """Return the class of this type name among the parts of a service or action, or None."""
    for part in vars(owner).values():
        if not isinstance(part, type) or part.__qualname__ == owner.__qualname__:
            continue
        if getattr(part, "_TYPE_NAME", None) == name:
            return part
        if (nested_part := _find_part(part, name)) is not None:
            return nested_part
    return None


def _kind_word(name: str) -> str:
    parts = name.split("/")
    return {"srv": "service", "action": "action"}.get(parts[1] if len(parts) == 3 else "", "message")


def _nearest_name_hint(name: str) -> str:
    import difflib

    from tfloom.rosidl.definition_files import KINDS, interface_names

    known_names = [known_name for kind in KINDS for known_name in interface_names(kind)]
    base = name.rpartition("/")[2]
    close_names = [known_name for known_name in known_names if known_name.endswith(f"/{base}")]
    close_names = close_names or difflib.get_close_matches(name, known_names, 1)
    return f"; did you mean '{close_names[0]}'?" if close_names else ""
