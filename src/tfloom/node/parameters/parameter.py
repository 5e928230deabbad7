"""Parameters: a name, a type and a value."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from enum import Enum, IntEnum
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from tfloom.common.seconds import plain_value
from tfloom.common.text import given_text, shortened
from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node.parameters.parameter_file import (
    EVERY_NODE,
    ParameterRule,
    checked_value,
    read_parameter_file,
)
from tfloom.node.values.names import full_node_name
from tfloom.node.values.scalars import parse_value

if TYPE_CHECKING:
    from pathlib import Path

    from typing_extensions import TypeVar as WithDefault

__all__ = [
    "PARAMETER_SEPARATOR_STRING",
    "AllowableParameterValue",
    "AllowableParameterValueT",
    "Parameter",
    "ParameterMsg",
    "get_parameter_value",
    "parameter_dict_from_yaml_file",
    "parameter_value_to_python",
]

PARAMETER_SEPARATOR_STRING = "."
ParameterMsg = rcl_msg.Parameter
"""The message of a parameter, by the name that rclpy's modules give it beside `Parameter`."""


AllowableParameterValue = (
    bool
    | int
    | float
    | str
    | Sequence[bytes]
    | Sequence[bool]
    | Sequence[int]
    | Sequence[float]
    | Sequence[str]
    | None
)

# Not the TypeVar of type_support, because `import rclpy` loads this module, and not that one.
if TYPE_CHECKING:
    AllowableParameterValueT = WithDefault("AllowableParameterValueT", default=Any)
else:
    AllowableParameterValueT = TypeVar("AllowableParameterValueT")


class ParameterType(IntEnum):
    """Types of parameters; the numbers are those of `rcl_interfaces/msg/ParameterType`."""

    NOT_SET = 0
    BOOL = 1
    INTEGER = 2
    DOUBLE = 3
    STRING = 4
    BYTE_ARRAY = 5
    BOOL_ARRAY = 6
    INTEGER_ARRAY = 7
    DOUBLE_ARRAY = 8
    STRING_ARRAY = 9

    # Printed by its name: in a sentence, a number says nothing.
    __str__ = Enum.__str__

    def __format__(self, format_spec: str) -> str:
        return str(self).__format__(format_spec)  # that of Enum prints the number before Python 3.11

    @classmethod
    def from_parameter_value(cls, parameter_value: Any) -> ParameterType:
        """Return the type of a value; that of an empty list is BYTE_ARRAY.

        Raises:
            TypeError: the value has no parameter type.
        """
        for kind, check in _CHECKS.items():
            if check(parameter_value):
                return kind
        raise _no_type(parameter_value)

    def check(self, parameter_value: Any) -> bool:
        """Return whether a value is of this type."""
        return _CHECKS[self](parameter_value)


def value_error(value: Any) -> TypeError | None:
    """Return the error of a Parameter with a value, or None, for callers whose tracebacks shall be short."""
    plain = plain_value(value)
    return None if any(check(plain) for check in _CHECKS.values()) else _no_type(value)


def no_parameter_error(parameters: Any) -> TypeError | None:
    """Return the error of what is not a sequence of Parameter objects, or None if it is one."""
    if isinstance(parameters, Parameter):
        return TypeError("'Parameter' object is not iterable: put it in brackets, [Parameter(…)]")
    for parameter in parameters:
        if not isinstance(parameter, Parameter):
            given = given_text(parameter)
            return TypeError(
                f"parameter must be instance of type 'rclpy.parameter.Parameter', got {given}: "
                "write [Parameter('name', value=1.0)]"
            )
    return None


def _no_type(value: Any) -> TypeError:
    names = ", ".join(kind.name for kind in ParameterType)
    given = given_text(value)
    return TypeError(f"The given value is not one of the allowed types '{names}'. It is {given}.")


# Printed, in error texts of set_parameters for example, as Parameter.Type.
ParameterType.__name__ = "Type"
ParameterType.__qualname__ = "Parameter.Type"


def _is_scalar(kind: type) -> Callable[[Any], bool]:
    # In Python, a bool is an int.
    return lambda value: isinstance(value, kind) and (kind is bool or not isinstance(value, bool))


def _is_list(item: Callable[[Any], bool]) -> Callable[[Any], bool]:
    def check(value: Any) -> bool:
        if isinstance(value, (str, bytes)):
            return False
        if hasattr(value, "tolist"):  # an array of numbers
            value = value.tolist()
        return isinstance(value, Sequence) and all(item(element) for element in value)

    return check


_CHECKS: dict[ParameterType, Callable[[Any], bool]] = {
    ParameterType.NOT_SET: lambda value: value is None,
    ParameterType.BOOL: _is_scalar(bool),
    ParameterType.INTEGER: _is_scalar(int),
    ParameterType.DOUBLE: _is_scalar(float),
    ParameterType.STRING: _is_scalar(str),
    ParameterType.BYTE_ARRAY: _is_list(lambda item: isinstance(item, bytes) and len(item) == 1),
    ParameterType.BOOL_ARRAY: _is_list(_is_scalar(bool)),
    ParameterType.INTEGER_ARRAY: _is_list(_is_scalar(int)),
    ParameterType.DOUBLE_ARRAY: _is_list(_is_scalar(float)),
    ParameterType.STRING_ARRAY: _is_list(_is_scalar(str)),
}
_FIELDS = {kind: f"{kind.name.lower()}_value" for kind in ParameterType if kind is not ParameterType.NOT_SET}


class Parameter(Generic[AllowableParameterValueT]):
    """A parameter: a name, a type and a value.

    Args:
        name: Parts are joined by dots.
        type_: The value's type; None: the type that the value has.
        value: None, bool, int, float, str, or a list of bytes (one each), bools, ints, floats or strings; those
            of numpy become Python's.

    Raises:
        TypeError: `type_` is not a Parameter.Type, or the value has no parameter type.
        ValueError: the value is not of this type.
    """

    Type = ParameterType
    __slots__ = ("_name", "_type_", "_value")

    def __init__(self, name: str, type_: ParameterType | None = None, value: Any = None) -> None:
        value = plain_value(value)
        if type_ is None:
            type_ = ParameterType.from_parameter_value(value)
        if not isinstance(type_, ParameterType):
            raise TypeError("type must be an instance of 'Parameter.Type'")
        if not type_.check(value):
            raise ValueError(f"Type '{type_}' and value '{shortened(value)}' do not agree")
        self._name = name
        self._type_ = type_
        self._value = value

    @classmethod
    def from_parameter_msg(cls, param_msg: rcl_msg.Parameter) -> Parameter:
        """Return the parameter of a `rcl_interfaces/msg/Parameter`."""
        kind = ParameterType(param_msg.value.type)
        return cls(param_msg.name, kind, parameter_value_to_python(param_msg.value))

    @property
    def name(self) -> str:
        """The parameter's name."""
        return self._name

    @property
    def type_(self) -> ParameterType:
        """The value's type."""
        return self._type_

    @property
    def value(self) -> Any:
        """The value; None if it is not set."""
        return self._value

    def get_parameter_value(self) -> rcl_msg.ParameterValue:
        """Return the value as a message."""
        message = rcl_msg.ParameterValue(type=self._type_.value)
        if self._type_ is not ParameterType.NOT_SET:
            value = self._value
            is_array = self._type_.value >= ParameterType.BYTE_ARRAY.value
            setattr(message, _FIELDS[self._type_], list(value) if is_array else value)
        return message

    def to_parameter_msg(self) -> rcl_msg.Parameter:
        """Return name and value as a message."""
        return rcl_msg.Parameter(name=self._name, value=self.get_parameter_value())

    def __repr__(self) -> str:
        return f"Parameter(name={self._name!r}, type_={self._type_}, value={self._value!r})"


def parameter_value_to_python(parameter_value: rcl_msg.ParameterValue) -> Any:
    """Return the value in a message; None if it is not set.

    Raises:
        RuntimeError: its type is not a parameter type.
    """
    try:
        kind = ParameterType(parameter_value.type)
    except ValueError:
        raise RuntimeError(f"unexpected parameter type {parameter_value.type}") from None
    if kind is ParameterType.NOT_SET:
        return None
    value = getattr(parameter_value, _FIELDS[kind])
    return list(value) if kind.value >= ParameterType.BYTE_ARRAY.value else value


def get_parameter_value(string_value: str) -> rcl_msg.ParameterValue:
    """Return the message for a value written as YAML; text that is not a value of another type is a string.

    The letters `y` and `n` are strings, because they are more often axes than answers.

    Raises:
        YamlLimitError: the value is too large, or nested too deep.
    """
    try:
        value = parse_value(string_value, nothing=string_value, letters=False)
        return Parameter("", value=checked_value("", value)).get_parameter_value()
    except (TypeError, ValueError) as error:
        from tfloom.common.yaml import YamlLimitError

        if isinstance(error, YamlLimitError):
            raise
        return Parameter("", value=string_value).get_parameter_value()


def parameter_dict_from_yaml_file(
    parameter_file: str | Path,
    use_wildcard: bool = False,
    target_nodes: list[str] | None = None,
    namespace: str = "",
) -> dict[str, rcl_msg.Parameter]:
    """Return the parameters in a file by name, with `namespace` before each.

    Args:
        parameter_file: The YAML file.
        use_wildcard: Whether values for `/**` are included; values for a node override them.
        target_nodes: Full names of the nodes to read; None: all.
        namespace: Prefix of each name, its final dot included.

    Raises:
        OSError: the file can't be read.
        ValueError: it isn't a parameter file.
        RuntimeError: a target node isn't in it, or no parameter is selected.
    """
    rules = read_parameter_file(parameter_file)
    nodes = list(dict.fromkeys(rule.node for rule in rules))
    if not use_wildcard:
        rules = [rule for rule in rules if rule.node != EVERY_NODE]
    if target_nodes is not None:
        targets = [full_node_name("/", node.strip("/")) for node in target_nodes]
        for target in targets:
            if target not in nodes and not (use_wildcard and EVERY_NODE in nodes):
                raise RuntimeError(no_parameters_text(target, nodes))
        rules = [rule for rule in rules if rule.node in (*targets, EVERY_NODE)]
    return parameter_dict(rules, namespace)


def no_parameters_text(node: str, nodes: list[str]) -> str:
    """Return the text of the error that a file has no parameters for a node, but only for others."""
    return f"Param file does not contain parameters for {node},only for nodes: {nodes} "


def parameter_dict(rules: Iterable[ParameterRule], namespace: str = "") -> dict[str, rcl_msg.Parameter]:
    """Return the parameters of rules by name, with `namespace` before each; other rules override those for `/**`.

    Raises:
        RuntimeError: there are no rules.
    """
    parameters: dict[str, rcl_msg.Parameter] = {}
    for rule in sorted(rules, key=lambda rule: rule.node != EVERY_NODE):
        name = f"{namespace}{rule.name}"
        parameters[name] = Parameter(name, value=rule.value).to_parameter_msg()
    if not parameters:
        raise RuntimeError("Param file does not contain selected parameters")
    return parameters
