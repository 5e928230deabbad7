"""`rosidl_parser.definition`: classes for IDL types and interface definitions, with the reference's names.

    AbstractType
      AbstractNestableType    BasicType  NamedType  NamespacedType
        AbstractGenericString
          AbstractString      BoundedString  UnboundedString
          AbstractWString     BoundedWString  UnboundedWString
      AbstractNestedType      Array
        AbstractSequence      BoundedSequence  UnboundedSequence

Types are equal when their classes and attributes are.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any

from tfloom.rosidl import spec
from tfloom.rosidl.spec import IDL_PRIMITIVES

SIGNED_NONEXPLICIT_INTEGER_TYPES = ("short", "long", "long long")
UNSIGNED_NONEXPLICIT_INTEGER_TYPES = ("unsigned short", "unsigned long", "unsigned long long")
NONEXPLICIT_INTEGER_TYPES = SIGNED_NONEXPLICIT_INTEGER_TYPES + UNSIGNED_NONEXPLICIT_INTEGER_TYPES
FLOATING_POINT_TYPES = ("float", "double", "long double")
CHARACTER_TYPES = ("char", "wchar")
BOOLEAN_TYPE = "boolean"
OCTET_TYPE = "octet"
SIGNED_EXPLICIT_INTEGER_TYPES = ("int8", "int16", "int32", "int64")
UNSIGNED_EXPLICIT_INTEGER_TYPES = ("uint8", "uint16", "uint32", "uint64")
EXPLICIT_INTEGER_TYPES = SIGNED_EXPLICIT_INTEGER_TYPES + UNSIGNED_EXPLICIT_INTEGER_TYPES
SIGNED_INTEGER_TYPES = SIGNED_NONEXPLICIT_INTEGER_TYPES + SIGNED_EXPLICIT_INTEGER_TYPES
UNSIGNED_INTEGER_TYPES = UNSIGNED_NONEXPLICIT_INTEGER_TYPES + UNSIGNED_EXPLICIT_INTEGER_TYPES
INTEGER_TYPES = SIGNED_INTEGER_TYPES + UNSIGNED_INTEGER_TYPES
BASIC_TYPES = (*INTEGER_TYPES, *FLOATING_POINT_TYPES, *CHARACTER_TYPES, BOOLEAN_TYPE, OCTET_TYPE)

EMPTY_STRUCTURE_REQUIRED_MEMBER_NAME = spec.EMPTY_FIELD
CONSTANT_MODULE_SUFFIX = "_Constants"
SERVICE_REQUEST_MESSAGE_SUFFIX = "_Request"
SERVICE_RESPONSE_MESSAGE_SUFFIX = "_Response"
SERVICE_EVENT_MESSAGE_SUFFIX = "_Event"
ACTION_GOAL_SUFFIX = "_Goal"
ACTION_RESULT_SUFFIX = "_Result"
ACTION_FEEDBACK_SUFFIX = "_Feedback"
ACTION_GOAL_SERVICE_SUFFIX = "_SendGoal"
ACTION_RESULT_SERVICE_SUFFIX = "_GetResult"
ACTION_FEEDBACK_MESSAGE_SUFFIX = "_FeedbackMessage"


class AbstractType:
    """A type of IDL: the base class of all of them."""

    __slots__: tuple[str, ...] = ()
    __hash__ = None  # type: ignore[assignment]

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self._values() == other._values()

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(map(repr, self._values()))})"

    def _values(self) -> list[Any]:
        return [
            getattr(self, name)
            for cls in reversed(type(self).__mro__)
            for name in cls.__dict__.get("__slots__", ())
        ]


class AbstractNestableType(AbstractType):
    """A type that an array or a sequence may hold."""

    __slots__ = ()


class BasicType(AbstractNestableType):
    """A number, a character, a boolean or an octet."""

    __slots__ = ("typename",)

    def __init__(self, typename: str) -> None:
        if typename not in BASIC_TYPES:
            raise AssertionError(f"'{typename}' is not a basic type")
        self.typename = typename


class NamedType(AbstractNestableType):
    """A type by its bare name."""

    __slots__ = ("name",)

    def __init__(self, name: str) -> None:
        self.name = name


class NamespacedType(AbstractNestableType):
    """A message, service or action by its full name."""

    __slots__ = ("name", "namespaces")

    def __init__(self, namespaces: Iterable[str], name: str) -> None:
        self.namespaces = list(namespaces)
        self.name = name

    def namespaced_name(self) -> tuple[str, ...]:
        """Return `("geometry_msgs", "msg", "Point")`."""
        return (*self.namespaces, self.name)


class AbstractGenericString(AbstractNestableType):
    """A string, bounded or not, of `char` or of `wchar`."""

    __slots__ = ()

    def has_maximum_size(self) -> bool:
        """Return whether its length is bounded."""
        return hasattr(self, "maximum_size")


class AbstractString(AbstractGenericString):
    """A string of 8-bit characters."""

    __slots__ = ()


class AbstractWString(AbstractGenericString):
    """A string of 16-bit characters."""

    __slots__ = ()


class BoundedString(AbstractString):
    """A string of at most `maximum_size` characters."""

    __slots__ = ("maximum_size",)

    def __init__(self, maximum_size: int) -> None:
        self.maximum_size = maximum_size


class UnboundedString(AbstractString):
    """A string of any length."""

    __slots__ = ()


class BoundedWString(AbstractWString):
    """A wide string of at most `maximum_size` characters."""

    __slots__ = ("maximum_size",)

    def __init__(self, maximum_size: int) -> None:
        self.maximum_size = maximum_size


class UnboundedWString(AbstractWString):
    """A wide string of any length."""

    __slots__ = ()


class AbstractNestedType(AbstractType):
    """An array or a sequence of `value_type`."""

    __slots__ = ("value_type",)

    def __init__(self, value_type: AbstractNestableType) -> None:
        self.value_type = value_type

    def has_maximum_size(self) -> bool:
        """Return whether its length has a bound."""
        return not isinstance(self, UnboundedSequence)


class Array(AbstractNestedType):
    """An array of `size` elements."""

    __slots__ = ("size",)

    def __init__(self, value_type: AbstractNestableType, size: int) -> None:
        super().__init__(value_type)
        self.size = size


class AbstractSequence(AbstractNestedType):
    """A sequence of variable length."""

    __slots__ = ()


class BoundedSequence(AbstractSequence):
    """A sequence of at most `maximum_size` elements."""

    __slots__ = ("maximum_size",)

    def __init__(self, value_type: AbstractNestableType, maximum_size: int) -> None:
        super().__init__(value_type)
        self.maximum_size = maximum_size


class UnboundedSequence(AbstractSequence):
    """A sequence of any length."""

    __slots__ = ()


class Annotation:
    """A name and a value."""

    def __init__(self, name: str, value: Any) -> None:
        self.name = name
        self.value = value


class Annotatable:
    """Base of elements that can have annotations."""

    position: tuple[int, int] = (0, 0)
    """Line and column in the file that was parsed, for errors."""

    def __init__(self) -> None:
        self.annotations: list[Annotation] = []

    def has_annotation(self, name: str) -> bool:
        """Return whether there is exactly one annotation of that name."""
        return len(self.get_annotation_values(name)) == 1

    def has_annotations(self, name: str) -> bool:
        """Return whether there is any annotation of that name."""
        return bool(self.get_annotation_values(name))

    def get_annotation_values(self, name: str) -> list[Any]:
        """Return the values of all annotations of that name."""
        return [annotation.value for annotation in self.annotations if annotation.name == name]

    def get_annotation_value(self, name: str) -> Any:
        """Return the value of the one annotation of that name.

        Raises:
            ValueError: there is none, or more than one.
        """
        values = self.get_annotation_values(name)
        if len(values) != 1:
            raise ValueError(f"there are {len(values)} annotations called '{name}'")
        return values[0]

    def get_comment_lines(self) -> list[str]:
        """Return the lines of all comments."""
        values = [
            verbatim for verbatim in self.get_annotation_values("verbatim") if isinstance(verbatim, dict)
        ]
        texts = [
            str(verbatim["text"])
            for verbatim in values
            if verbatim.get("language") == "comment" and "text" in verbatim
        ]
        return [line for text in texts for line in text.splitlines()]


class Member(Annotatable):
    """A field of a structure: a name, a type and annotations."""

    def __init__(self, type_: AbstractType, name: str) -> None:
        super().__init__()
        self.type = type_
        self.name = name


class Constant(Annotatable):
    """A constant of a message: a name, a type, a value and annotations."""

    def __init__(self, name: str, type_: AbstractType, value: Any) -> None:
        super().__init__()
        self.name = name
        self.type = type_
        self.value = value


class Structure(Annotatable):
    """The fields of a message."""

    def __init__(self, namespaced_type: NamespacedType, members: list[Member] | None = None) -> None:
        super().__init__()
        self.namespaced_type = namespaced_type
        self.members = members or []

    def has_any_member_with_annotation(self, name: str) -> bool:
        """Return whether a field has an annotation of that name."""
        return any(member.has_annotation(name) for member in self.members)


class Message:
    """The structure of a message, which has its fields, and its constants."""

    def __init__(self, structure: Structure) -> None:
        self.structure = structure
        self.constants: list[Constant] = []


class Service:
    """Request, response and event."""

    def __init__(self, namespaced_type: NamespacedType, request: Message, response: Message) -> None:
        self.namespaced_type = namespaced_type
        self.request_message = request
        self.response_message = response
        self.event_message = _event_message(namespaced_type)


class Action:
    """Goal, result and feedback, and the services and message that carry them."""

    def __init__(
        self, namespaced_type: NamespacedType, goal: Message, result: Message, feedback: Message
    ) -> None:
        self.namespaced_type = namespaced_type
        self.goal = goal
        self.result = result
        self.feedback = feedback
        name = "/".join(namespaced_type.namespaced_name())
        parts = [spec.Message(f"{name}_{part}", ()) for part in ("Goal", "Result", "Feedback")]
        whole = spec.action(name, *parts)
        self.send_goal_service = to_definition(whole.send_goal)
        self.get_result_service = to_definition(whole.get_result)
        self.feedback_message = to_definition(whole.feedback_message)
        self.implicit_includes: list[Include] = [
            Include("builtin_interfaces/msg/Time.idl"),
            Include("unique_identifier_msgs/msg/UUID.idl"),
        ]


class Include:
    """Another file that a definition needs."""

    def __init__(self, locator: str) -> None:
        self.locator = locator


class IdlLocator:
    """The path of a file."""

    def __init__(self, basepath: str | os.PathLike[str], relative_path: str | os.PathLike[str]) -> None:
        self.basepath = basepath
        self.relative_path = relative_path

    def get_absolute_path(self) -> Any:
        """Return the path as a whole."""
        from pathlib import Path

        return Path(self.basepath) / self.relative_path


class IdlContent:
    """The definitions in a file."""

    def __init__(self) -> None:
        self.elements: list[Any] = []

    def get_elements_of_type(self, type_: type) -> list[Any]:
        """Return the elements of one kind."""
        return [element for element in self.elements if isinstance(element, type_)]


class IdlFile:
    """A file and its definitions."""

    def __init__(self, locator: IdlLocator, content: IdlContent) -> None:
        self.locator = locator
        self.content = content


def to_type(type_: spec.Type) -> AbstractType:
    """Return a field's type as an object of this module."""
    element = _to_element(type_)
    if type_.shape == "array":
        return Array(element, type_.length)
    if type_.shape == "bounded":
        return BoundedSequence(element, type_.length)
    return UnboundedSequence(element) if type_.shape else element


def to_namespaced_type(name: str) -> NamespacedType:
    """Return `geometry_msgs/msg/Point` as an object of this module."""
    *namespaces, base = name.split("/")
    return NamespacedType(namespaces, base)


def _to_element(type_: spec.Type) -> AbstractNestableType:
    if type_.base == "string":
        return BoundedString(type_.string_bound) if type_.string_bound else UnboundedString()
    if type_.base == "wstring":
        return BoundedWString(type_.string_bound) if type_.string_bound else UnboundedWString()
    return (
        BasicType(IDL_PRIMITIVES.get(type_.base, type_.base))
        if type_.is_primitive
        else to_namespaced_type(type_.base)
    )


def to_definition(interface: spec.Interface) -> Any:
    """Return a spec as a `Message`, `Service` or `Action` of this module."""
    namespaced_type = to_namespaced_type(interface.name)
    if isinstance(interface, spec.Service):
        return Service(namespaced_type, to_definition(interface.request), to_definition(interface.response))
    if isinstance(interface, spec.Action):
        parts = (interface.goal, interface.result, interface.feedback)
        return Action(namespaced_type, *map(to_definition, parts))
    members = [_to_member(field) for field in interface.wire_fields]
    message = Message(Structure(namespaced_type, members))
    message.constants = [
        Constant(constant.name, to_type(constant.type), constant.value) for constant in interface.constants
    ]
    return message


def _to_member(field: spec.Field) -> Member:
    member = Member(to_type(field.type), field.name)
    if field.comment:
        member.annotations.append(Annotation("verbatim", {"language": "comment", "text": field.comment}))
    if field.default is not None:
        member.annotations.append(Annotation("default", {"value": field.default}))
    return member


def _event_message(namespaced_type: NamespacedType) -> Any:
    name = "/".join(namespaced_type.namespaced_name())
    empty = (spec.Message(f"{name}_Request", ()), spec.Message(f"{name}_Response", ()))
    return to_definition(spec.service(name, *empty).event)
