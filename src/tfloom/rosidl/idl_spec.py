"""The specs of interfaces that .idl files define: the same values as those of .msg, .srv and .action files."""

from __future__ import annotations

import ast
from typing import Any

from tfloom.rosidl import spec
from tfloom.rosidl.definition import (
    AbstractGenericString,
    AbstractNestedType,
    AbstractType,
    AbstractWString,
    Action,
    Annotatable,
    Array,
    BasicType,
    BoundedSequence,
    BoundedString,
    BoundedWString,
    Constant,
    Member,
    Message,
    NamespacedType,
    Service,
)
from tfloom.rosidl.idl_parser import parse_content
from tfloom.rosidl.parse import ParseError
from tfloom.rosidl.spec import IDL_PRIMITIVES

_NO_FIELD_TYPES = {
    "char": "uint8",
    "wchar": "uint16",
    "long double": "double",
}
"""IDL's types that tfloom has no field type for, each with the one to use instead."""
_BASES = {theirs: ours for ours, theirs in IDL_PRIMITIVES.items() if ours != "char"}


def parse_idl(text: str, name: str, path: str) -> spec.Interface:
    """Parse the text of an .idl file.

    Args:
        text: The content of the file.
        name: `package/kind/Name`, which the file must define.
        path: Path of the text, for errors.

    Raises:
        ParseError: the text is not IDL as ROS has it, or defines something else.
    """
    element = parse_content(text, path).elements[-1]
    return _Converter(path).interface(element, name)


class _Converter:
    def __init__(self, path: str) -> None:
        self.path = path

    def fail(self, at: Annotatable, reason: str) -> ParseError:
        return ParseError(self.path, *at.position, reason)

    def interface(self, element: Message | Service | Action, name: str) -> spec.Interface:
        first, type_ = _first_structure(element)
        defined = "/".join(type_.namespaced_name())
        kind = {Message: "msg", Service: "srv", Action: "action"}[type(element)]
        if defined != name or name.split("/")[1] != kind:
            what = {"msg": "message", "srv": "service", "action": "action"}
            wanted = f"the {what[name.split('/')[1]]} '{name.replace('/', '::')}'"
            raise self.fail(
                first,
                f"the file defines the {what[kind]} '{defined.replace('/', '::')}', and by its path {wanted}",
            )
        if isinstance(element, Message):
            return self.message(element)
        if isinstance(element, Service):
            return spec.service(
                name, self.message(element.request_message), self.message(element.response_message)
            )
        parts = (element.goal, element.result, element.feedback)
        return spec.action(name, *map(self.message, parts))

    def message(self, message: Message) -> spec.Message:
        structure = message.structure
        name = "/".join(structure.namespaced_type.namespaced_name())
        fields = tuple(self.field(member) for member in structure.members)
        if [(field.name, field.type) for field in fields] == [(spec.EMPTY_FIELD, spec.Type("uint8"))]:
            fields = ()
        constants = tuple(self.constant(constant) for constant in message.constants)
        return spec.Message(name, fields, constants, " ".join(structure.get_comment_lines()))

    def field(self, member: Member) -> spec.Field:
        type_ = self.type(member.type, member)
        values = member.get_annotation_values("default")
        default: spec.Value = None
        if values:
            if len(values) > 1 or not isinstance(values[0], dict) or list(values[0]) != ["value"]:
                raise self.fail(member, "a default is written '@default (value=...)', once")
            default = self.default(member, type_, values[0]["value"])
        comment = " ".join(member.get_comment_lines())
        return spec.Field(member.name, type_, default, comment, member.position)

    def constant(self, constant: Constant) -> spec.Constant:
        type_ = self.type(constant.type, constant)._replace(string_bound=0)
        value = self.single(constant, type_, constant.value)
        return spec.Constant(constant.name, type_, value, " ".join(constant.get_comment_lines()))

    def type(self, type_: AbstractType, at: Annotatable) -> spec.Type:
        if isinstance(type_, AbstractNestedType):
            element = self.type(type_.value_type, at)
            if isinstance(type_, Array):
                return element._replace(shape="array", length=type_.size)
            if isinstance(type_, BoundedSequence):
                return element._replace(shape="bounded", length=type_.maximum_size)
            return element._replace(shape="unbounded")
        if isinstance(type_, AbstractGenericString):
            bound = type_.maximum_size if isinstance(type_, (BoundedString, BoundedWString)) else 0
            return spec.Type("wstring" if isinstance(type_, AbstractWString) else "string", bound)
        if isinstance(type_, NamespacedType):
            return self.reference(type_, at)
        if not isinstance(type_, BasicType) or type_.typename in _NO_FIELD_TYPES:
            name = getattr(type_, "typename", "")
            raise self.fail(at, f"tfloom has no fields of IDL's type '{name}': use {_NO_FIELD_TYPES[name]}")
        return spec.Type(_BASES.get(type_.typename, type_.typename))

    def reference(self, type_: NamespacedType, at: Annotatable) -> spec.Type:
        parts = type_.namespaced_name()
        if len(parts) != 3:
            raise self.fail(at, f"a message is written 'package::msg::Name', not '{'::'.join(parts)}'")
        return spec.Type("/".join(parts))

    def default(self, member: Member, type_: spec.Type, value: Any) -> spec.Value:
        if not type_.is_primitive:
            raise self.fail(member, f"a field of type '{type_}' takes no default")
        if not type_.shape:
            return self.single(member, type_, value)
        try:
            values = ast.literal_eval(value)
        except (ValueError, SyntaxError, TypeError, MemoryError, RecursionError):
            values = None
        if not isinstance(values, (tuple, list)):
            raise self.fail(member, f"""the default of '{type_}' is written "(1, 2)", not {value!r}""")
        if type_.shape == "array" and len(values) != type_.length:
            raise self.fail(member, f"{type_} takes {type_.length} values, got {len(values)}")
        if type_.shape == "bounded" and len(values) > type_.length:
            raise self.fail(member, f"{type_} takes at most {type_.length} values, got {len(values)}")
        return [self.single(member, type_.element, element) for element in values]

    def single(self, at: Annotatable, type_: spec.Type, value: Any) -> spec.Value:
        """Return a default's or a constant's value as the spec has it; fail if it is none of the type."""
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if type_.base in spec.STRINGS:
            if isinstance(value, str) and (not type_.string_bound or len(value) <= type_.string_bound):
                return value
        elif type_.base == "bool":
            if isinstance(value, bool) or value in (0, 1):
                return bool(value)
        elif type_.base in spec.FLOATS:
            if is_number:
                return float(value)
        elif is_number and isinstance(value, int):
            least, greatest = spec.INTEGER_RANGES[type_.base]
            if not least <= value <= greatest:
                raise self.fail(at, f"{value} is outside {type_.base}'s range [{least}, {greatest}]")
            return bytes([value]) if type_.base == "byte" else value
        raise self.fail(at, f"{value!r} is not a value of the type '{type_}'")


def _first_structure(element: Message | Service | Action) -> tuple[Annotatable, NamespacedType]:
    if isinstance(element, Message):
        return element.structure, element.structure.namespaced_type
    first = element.request_message if isinstance(element, Service) else element.goal
    return first.structure, element.namespaced_type
