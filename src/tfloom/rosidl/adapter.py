"""The classes and functions of `rosidl_adapter.parser`: definitions (.msg, .srv, .action) as specifications."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from tfloom.rosidl import spec
from tfloom.rosidl.adapter_comments import annotations_of, find_comments
from tfloom.rosidl.literal import parse_value
from tfloom.rosidl.parse import ParseError, parse_interface, parse_type, read_text

__all__ = [
    "ACTION_FEEDBACK_MESSAGE_SUFFIX",
    "ACTION_FEEDBACK_SUFFIX",
    "ACTION_GOAL_SERVICE_SUFFIX",
    "ACTION_GOAL_SUFFIX",
    "ACTION_REQUEST_RESPONSE_SEPARATOR",
    "ACTION_RESULT_SERVICE_SUFFIX",
    "ACTION_RESULT_SUFFIX",
    "ARRAY_UPPER_BOUND_TOKEN",
    "COMMENT_DELIMITER",
    "CONSTANT_SEPARATOR",
    "PACKAGE_NAME_MESSAGE_TYPE_SEPARATOR",
    "PRIMITIVE_TYPES",
    "SERVICE_EVENT_MESSAGE_SUFFIX",
    "SERVICE_REQUEST_MESSAGE_SUFFIX",
    "SERVICE_REQUEST_RESPONSE_SEPARATOR",
    "SERVICE_RESPONSE_MESSAGE_SUFFIX",
    "STRING_UPPER_BOUND_TOKEN",
    "ActionSpecification",
    "BaseType",
    "Constant",
    "Field",
    "InvalidActionSpecification",
    "InvalidFieldDefinition",
    "InvalidResourceName",
    "InvalidServiceSpecification",
    "InvalidSpecification",
    "InvalidValue",
    "MessageSpecification",
    "ServiceSpecification",
    "Type",
    "UnknownMessageType",
    "is_valid_constant_name",
    "is_valid_field_name",
    "is_valid_message_name",
    "is_valid_package_name",
    "parse_action_file",
    "parse_action_string",
    "parse_message_file",
    "parse_message_string",
    "parse_primitive_value_string",
    "parse_service_file",
    "parse_service_string",
    "parse_value_string",
    "validate_field_types",
]

PACKAGE_NAME_MESSAGE_TYPE_SEPARATOR = "/"
COMMENT_DELIMITER = "#"
CONSTANT_SEPARATOR = "="
ARRAY_UPPER_BOUND_TOKEN = "<="  # noqa: S105
STRING_UPPER_BOUND_TOKEN = "<="  # noqa: S105
SERVICE_REQUEST_RESPONSE_SEPARATOR = "---"
SERVICE_REQUEST_MESSAGE_SUFFIX = "_Request"
SERVICE_RESPONSE_MESSAGE_SUFFIX = "_Response"
SERVICE_EVENT_MESSAGE_SUFFIX = "_Event"
ACTION_REQUEST_RESPONSE_SEPARATOR = "---"
ACTION_GOAL_SUFFIX = "_Goal"
ACTION_RESULT_SUFFIX = "_Result"
ACTION_FEEDBACK_SUFFIX = "_Feedback"
ACTION_GOAL_SERVICE_SUFFIX = "_SendGoal"
ACTION_RESULT_SERVICE_SUFFIX = "_GetResult"
ACTION_FEEDBACK_MESSAGE_SUFFIX = "_FeedbackMessage"

PRIMITIVE_TYPES = [
    "bool",
    "byte",
    "char",
    "float32",
    "float64",
    "int8",
    "uint8",
    "int16",
    "uint16",
    "int32",
    "uint32",
    "int64",
    "uint64",
    "string",
    "wstring",
    "duration",
    "time",
]

_PACKAGE = re.compile(r"(?!.*__)(?!.*_$)[a-z][a-z0-9_]*")
_MESSAGE = re.compile(r"[A-Z][A-Za-z0-9]*")
_FIELD = re.compile(r"(?!.*__)(?!.*_$)[a-z][a-z0-9_]*")
_PART_SUFFIX = re.compile(r"_(Request|Response|Event|Goal|Result|Feedback)$")
"""What the name of a part of a service or an action ends with."""
_CONSTANT = re.compile(r"(?!.*__)(?!.*_$)[A-Z][A-Z0-9_]*")


class InvalidSpecification(Exception):  # here and below the reference's names
    """A definition is invalid."""


class InvalidServiceSpecification(InvalidSpecification):
    """A definition of a service doesn't have its two parts."""


class InvalidActionSpecification(InvalidSpecification):
    """A definition of an action doesn't have its three parts."""


class InvalidResourceName(InvalidSpecification):
    """A name of a package, message, field or constant is invalid."""


class InvalidFieldDefinition(InvalidSpecification, ValueError):
    """A line of a definition is invalid; the text has file, line and column."""


class UnknownMessageType(InvalidSpecification):
    """A field has a type that is unknown."""


class InvalidValue(Exception):
    """A default or a constant isn't a value of its type.

    Args:
        type_: The type.
        value_string: The text.
        message_suffix: What the error's text ends with.
    """

    def __init__(self, type_: Any, value_string: str, message_suffix: str | None = None) -> None:
        suffix = f": {message_suffix}" if message_suffix else ""
        super().__init__(f"value '{value_string}' can not be converted to type '{type_}'{suffix}")


def is_valid_package_name(name: str) -> bool:
    """Return whether a text can be a package's name."""
    return _PACKAGE.fullmatch(name) is not None


def is_valid_field_name(name: str) -> bool:
    """Return whether a text can be a field's name."""
    return _FIELD.fullmatch(name) is not None


def is_valid_constant_name(name: str) -> bool:
    """Return whether a text can be a constant's name."""
    return _CONSTANT.fullmatch(name) is not None


def is_valid_message_name(name: str) -> bool:
    """Return whether a text can be a message's name; that of a part of a service or an action has a suffix."""
    return _MESSAGE.fullmatch(_PART_SUFFIX.sub("", name)) is not None


class BaseType:
    """The type of a single value: a primitive, or a message.

    Args:
        type_string: As a definition writes it: `string<=10`, `Point`, `geometry_msgs/Point`.
        context_package_name: The package of a message's bare name.

    Raises:
        TypeError: a string's bound is not a number above 0.
        InvalidResourceName: it is neither a primitive nor a message's name.
    """

    __slots__ = ["pkg_name", "string_upper_bound", "type"]

    def __init__(self, type_string: str, context_package_name: str | None = None) -> None:
        self.pkg_name: str | None = None
        self.string_upper_bound: int | None = None
        base, bound_token, bound = type_string.partition(STRING_UPPER_BOUND_TOKEN)
        self.type = base
        if base in PRIMITIVE_TYPES:
            if bound_token:
                self.string_upper_bound = _bound(bound, type_string)
            return
        package, _, name = base.rpartition(PACKAGE_NAME_MESSAGE_TYPE_SEPARATOR)
        package = package.removesuffix("/msg") or context_package_name or ""
        if not is_valid_package_name(package):
            raise InvalidResourceName(f"'{package}' is not a package's name, in the type '{type_string}'")
        if not is_valid_message_name(name):
            raise InvalidResourceName(f"'{name}' is not a message's name, in the type '{type_string}'")
        self.pkg_name, self.type = package, name

    def is_primitive_type(self) -> bool:
        """Return whether it is a primitive, not a message."""
        return self.pkg_name is None

    def __eq__(self, other: object) -> bool:
        return isinstance(other, BaseType) and str(self) == str(other)

    def __hash__(self) -> int:
        return hash(str(self))

    def __str__(self) -> str:
        """Return the type as a definition writes it."""
        if self.pkg_name is not None:
            return f"{self.pkg_name}/{self.type}"
        bound = (
            "" if self.string_upper_bound is None else f"{STRING_UPPER_BOUND_TOKEN}{self.string_upper_bound}"
        )
        return f"{self.type}{bound}"


def _bound(text: str, type_string: str) -> int:
    if not text.isdecimal() or not int(text):
        raise TypeError(f"the bound of the type '{type_string}' must be a valid integer value > 0")
    return int(text)


class Type(BaseType):
    """The type of a field: a single value, an array or a sequence.

    Args:
        type_string: As a definition writes it: `float64[36]`, `string<=10[<=5]`, `Point[]`.
        context_package_name: The package of a message's bare name.

    Raises:
        TypeError: a length or a bound is not a number above 0.
        InvalidResourceName: the type of an element is neither a primitive nor a message's name.
    """

    __slots__ = ["array_size", "is_array", "is_upper_bound"]

    def __init__(self, type_string: str, context_package_name: str | None = None) -> None:
        element, bracket, rest = type_string.partition("[")
        if not bracket and element.endswith("]"):
            raise TypeError(f"the type '{type_string}' ends with ']' but does not contain a '['")
        self.is_array = bool(bracket)
        self.array_size: int | None = None
        self.is_upper_bound = False
        if bracket:
            if not rest.endswith("]"):
                raise TypeError(f"the type '{type_string}' is missing its closing bracket")
            size = rest[:-1]
            self.is_upper_bound = size.startswith(ARRAY_UPPER_BOUND_TOKEN)
            if size:
                self.array_size = _bound(size.removeprefix(ARRAY_UPPER_BOUND_TOKEN), type_string)
        super().__init__(element, context_package_name)

    def is_dynamic_array(self) -> bool:
        """Return whether it is a sequence, whose length varies."""
        return self.is_array and (self.array_size is None or self.is_upper_bound)

    def is_fixed_size_array(self) -> bool:
        """Return whether it is an array, whose length is fixed."""
        return self.is_array and not self.is_dynamic_array()

    def __str__(self) -> str:
        """Return the type as a definition writes it."""
        if not self.is_array:
            return super().__str__()
        bound = ARRAY_UPPER_BOUND_TOKEN if self.is_upper_bound else ""
        return f"{super().__str__()}[{bound}{'' if self.array_size is None else self.array_size}]"


class Constant:
    """A constant of a message.

    Args:
        primitive_type: Name of its type.
        name: Its name.
        value_string: Its value, as a definition writes it.

    Raises:
        TypeError: the type is not a primitive.
        NameError: the name is not a constant's.
        ValueError: the value is None.
        InvalidValue: the text isn't a value of the type.
    """

    __slots__ = ["annotations", "name", "type", "value"]

    def __init__(self, primitive_type: str, name: str, value_string: str) -> None:
        if primitive_type not in PRIMITIVE_TYPES:
            raise TypeError(f"the constant type '{primitive_type}' must be a primitive type")
        if not is_valid_constant_name(name):
            raise NameError(f"the constant name '{name}' is not valid")
        if value_string is None:
            raise ValueError("the constant value must not be 'None'")
        self.type = primitive_type
        self.name = name
        self.value: Any = parse_primitive_value_string(Type(primitive_type), value_string)
        self.annotations: dict[str, Any] = {}

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Constant) and str(self) == str(other)

    def __hash__(self) -> int:
        return hash(str(self))

    def __str__(self) -> str:
        """Return the constant as a definition writes it."""
        value = f"'{self.value}'" if self.type in {"string", "wstring"} else self.value
        return f"{self.type} {self.name}={value}"


class Field:
    """A field of a message.

    Args:
        type_: Its type.
        name: Its name.
        default_value_string: Its default, as a definition writes it; None if it has none.

    Raises:
        TypeError: the type is no `Type`.
        NameError: the name is not a field's.
        InvalidValue: the default isn't a value of the type.
    """

    __slots__ = ["annotations", "default_value", "name", "type"]

    def __init__(self, type_: Type, name: str, default_value_string: str | None = None) -> None:
        if not isinstance(type_, Type):
            raise TypeError(f"the field type '{type_}' must be a 'Type' instance")
        if not is_valid_field_name(name):
            raise NameError(f"the field name '{name}' is not valid")
        self.type = type_
        self.name = name
        self.default_value: Any = (
            None if default_value_string is None else parse_value_string(type_, default_value_string)
        )
        self.annotations: dict[str, Any] = {}

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Field) and str(self) == str(other)

    def __hash__(self) -> int:
        return hash(str(self))

    def __str__(self) -> str:
        """Return the field as a definition writes it."""
        default = self.default_value
        if default is None:
            return f"{self.type} {self.name}"
        quoted = self.type.is_primitive_type() and not self.type.is_array and isinstance(default, str)
        return f"{self.type} {self.name} {repr(default) if quoted else default}"


class MessageSpecification:
    """A message: its constants and fields.

    Args:
        pkg_name: Its package.
        msg_name: Its name.
        fields: Its fields.
        constants: Its constants.

    Raises:
        TypeError: one of them is none.
        ValueError: two fields, or two constants, have one name.
    """

    def __init__(
        self, pkg_name: str, msg_name: str, fields: Iterable[Field], constants: Iterable[Constant]
    ) -> None:
        self.base_type = BaseType(f"{pkg_name}{PACKAGE_NAME_MESSAGE_TYPE_SEPARATOR}{msg_name}")
        self.msg_name = msg_name
        self.annotations: dict[str, Any] = {}
        self.fields = list(fields)
        self.constants = list(constants)
        for members, kind in ((self.fields, Field), (self.constants, Constant)):
            for number, member in enumerate(members):
                if not isinstance(member, kind):
                    word = kind.__name__
                    raise TypeError(f"{word.lower()} {number} must be a '{word}' instance, not {member!r}")
            names = [member.name for member in members]
            if twice := sorted({name for name in names if names.count(name) > 1}):
                raise ValueError(f"{self.base_type} has several members of one name: {', '.join(twice)}")

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, MessageSpecification)
            and self.base_type == other.base_type
            and self.fields == other.fields
            and self.constants == other.constants
        )

    def __hash__(self) -> int:
        return hash(self.base_type)

    def __str__(self) -> str:
        """Return the definition: the name as a comment, the constants, the fields."""
        return "\n".join([f"# {self.base_type}", *map(str, self.constants), *map(str, self.fields)])


class ServiceSpecification:
    """A service: the messages of request and response.

    Args:
        pkg_name: Its package.
        srv_name: Its name.
        request: The request.
        response: The response.
    """

    def __init__(
        self, pkg_name: str, srv_name: str, request: MessageSpecification, response: MessageSpecification
    ) -> None:
        self.pkg_name = pkg_name
        self.srv_name = srv_name
        self.request = request
        self.response = response

    def __str__(self) -> str:
        """Return the definition: the name as a comment, the request, the response."""
        return f"# {self.pkg_name}/{self.srv_name}\n{self.request}\n---\n{self.response}"


class ActionSpecification:
    """An action: the messages of goal, result and feedback.

    Args:
        pkg_name: Its package.
        action_name: Its name.
        goal: The goal.
        result: The result.
        feedback: The feedback.
    """

    def __init__(
        self,
        pkg_name: str,
        action_name: str,
        goal: MessageSpecification,
        result: MessageSpecification,
        feedback: MessageSpecification,
    ) -> None:
        self.pkg_name = pkg_name
        self.action_name = action_name
        self.goal = goal
        self.result = result
        self.feedback = feedback

    def __str__(self) -> str:
        """Return the action's name."""
        return f"{self.pkg_name}/{self.action_name}"


def parse_message_file(pkg_name: str, interface_filename: str | os.PathLike[str]) -> MessageSpecification:
    """Return the message that a file defines, whose name is the file's; errors as of `parse_message_string`."""
    path = Path(interface_filename)
    return parse_message_string(pkg_name, path.stem, _text(path))


def parse_service_file(pkg_name: str, interface_filename: str | os.PathLike[str]) -> ServiceSpecification:
    """Return the service that a file defines, whose name is the file's; errors as of `parse_service_string`."""
    path = Path(interface_filename)
    return parse_service_string(pkg_name, path.stem, _text(path))


def parse_action_file(pkg_name: str, interface_filename: str | os.PathLike[str]) -> ActionSpecification:
    """Return the action that a file defines, whose name is the file's; errors as of `parse_action_string`."""
    path = Path(interface_filename)
    return parse_action_string(pkg_name, path.stem, _text(path))


def _text(path: Path) -> str:
    try:
        return read_text(path)
    except ParseError as error:
        raise InvalidFieldDefinition(str(error)) from None


def parse_message_string(pkg_name: str, msg_name: str, message_string: str) -> MessageSpecification:
    """Return the message of a definition.

    Args:
        pkg_name: Its package.
        msg_name: Its name.
        message_string: The definition.

    Raises:
        InvalidFieldDefinition: a line is invalid; the text has line and column.
        InvalidResourceName: a name is invalid.
    """
    return _message(_parsed(pkg_name, "msg", msg_name, message_string), message_string)


def parse_service_string(pkg_name: str, srv_name: str, message_string: str) -> ServiceSpecification:
    """Return the service of a definition; arguments and errors as of `parse_message_string`.

    Raises:
        InvalidServiceSpecification: it doesn't have two parts.
    """
    texts = _parts(message_string, 2, f"{pkg_name}/{srv_name}", InvalidServiceSpecification)
    service = _parsed(pkg_name, "srv", srv_name, message_string)
    return ServiceSpecification(
        pkg_name, srv_name, *map(_message, (service.request, service.response), texts)
    )


def parse_action_string(pkg_name: str, action_name: str, action_string: str) -> ActionSpecification:
    """Return the action of a definition; arguments and errors as of `parse_message_string`.

    Raises:
        InvalidActionSpecification: it doesn't have three parts.
    """
    texts = _parts(action_string, 3, f"{pkg_name}/{action_name}", InvalidActionSpecification)
    action = _parsed(pkg_name, "action", action_name, action_string)
    parts = (action.goal, action.result, action.feedback)
    return ActionSpecification(pkg_name, action_name, *map(_message, parts, texts))


def _parts(text: str, count: int, name: str, error: type[InvalidSpecification]) -> list[str]:
    """Return the parts of a definition, which lines of `---` divide."""
    parts: list[list[str]] = [[]]
    for line in text.splitlines():
        if line.strip() == SERVICE_REQUEST_RESPONSE_SEPARATOR:
            parts.append([])
        else:
            parts[-1].append(line)
    if len(parts) != count:
        raise error(f"the definition of {name} has {len(parts)} of its {count} parts, divided by '---'")
    return ["\n".join(lines) for lines in parts]


def _parsed(package: str, kind: str, name: str, text: str) -> Any:
    # A part of a service or an action is parsed as a message, too, whose suffix the parser takes for no name.
    plain = _PART_SUFFIX.sub("", name)
    try:
        interface = parse_interface(text, f"{package}/{kind}/{plain}")
    except ParseError as error:
        raise InvalidFieldDefinition(str(error)) from None
    except ValueError as error:
        raise InvalidResourceName(str(error)) from None
    return interface._replace(name=f"{package}/{kind}/{name}")


def _message(message: spec.Message, text: str) -> MessageSpecification:
    package, _, name = message.name.split("/")
    specification = MessageSpecification(
        package, name, map(_field, message.fields), map(_constant, message.constants)
    )
    comments = find_comments(text)
    specification.annotations = annotations_of(comments.message)
    elements: list[Field | Constant] = [*specification.fields, *specification.constants]
    for element in elements:
        element.annotations = annotations_of(comments.elements.get(element.name, []))
    return specification


def _field(field: spec.Field) -> Field:
    converted = Field(Type(str(field.type)), field.name)
    converted.default_value = _plain(field.default)
    return converted


def _constant(constant: spec.Constant) -> Constant:
    # Its value has been parsed, and written out again it could be another: a text with quotes in it.
    converted = Constant.__new__(Constant)
    converted.type, converted.name = constant.type.base, constant.name
    converted.value = _plain(constant.value)
    converted.annotations = {}
    return converted


def _plain(value: Any) -> Any:
    """Return a value as the reference has it: of a byte its number."""
    if isinstance(value, bytes):
        return value[0]
    return [_plain(item) for item in value] if isinstance(value, list) else value


def parse_value_string(type_: Type, value_string: str) -> Any:
    """Return the value that a text stands for: a single one, or a list for an array or a sequence.

    Raises:
        InvalidValue: it isn't a value of the type.
        NotImplementedError: the type is a message's.
    """
    if not type_.is_primitive_type():
        raise NotImplementedError(f"a field of type '{type_}' takes no default")
    return _value(type_, value_string)


def parse_primitive_value_string(type_: Type, value_string: str) -> Any:
    """Return the value of a single primitive that a text stands for.

    Raises:
        ValueError: the type is a message's, an array or a sequence.
        InvalidValue: it isn't a value of the type.
    """
    if not type_.is_primitive_type() or type_.is_array:
        raise ValueError("the passed type must be a non-array primitive type")
    return _value(type_, value_string)


def _value(type_: Type, text: str) -> Any:
    try:
        return _plain(parse_value(parse_type(str(type_)), text))
    except ValueError as error:
        raise InvalidValue(type_, text, str(error)) from None


def validate_field_types(
    spec: MessageSpecification | ServiceSpecification | ActionSpecification,
    known_msg_types: Iterable[BaseType],
) -> None:
    """Check that the types of all fields are primitives or known.

    Raises:
        UnknownMessageType: one is neither.
    """
    known = set(map(str, known_msg_types))
    if isinstance(spec, MessageSpecification):
        messages = [spec]
    elif isinstance(spec, ServiceSpecification):
        messages = [spec.request, spec.response]
    else:
        messages = [spec.goal, spec.result, spec.feedback]
    for message in messages:
        for field in message.fields:
            element = field.type if not field.type.is_array else BaseType(str(field.type).partition("[")[0])
            if not field.type.is_primitive_type() and str(element) not in known:
                raise UnknownMessageType(
                    f"{message.base_type} has the field '{field.type} {field.name}' of an unknown type"
                )
