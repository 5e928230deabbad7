"""What the node's room raises.

Exception
├── NotInitializedException             a context was used before init or after shutdown
├── ROSInterruptException               shutdown came while something slept
├── NoTypeSupportImportedException      a class that is no message was given as a type
├── NameValidationException             a name that ROS doesn't allow: which, why, and where in it
│   ├── InvalidNamespaceException
│   ├── InvalidNodeNameException
│   ├── InvalidTopicNameException
│   └── InvalidServiceNameException
└── ParameterException
    ├── ParameterNotDeclaredException
    ├── ParameterAlreadyDeclaredException
    ├── InvalidParameterException       its name isn't valid
    ├── InvalidParameterTypeException
    ├── InvalidParameterValueException
    ├── ParameterImmutableException
    └── ParameterUninitializedException
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tfloom.node.parameters.parameter import Parameter

__all__ = [
    "InvalidHandle",
    "InvalidNamespaceException",
    "InvalidNodeNameException",
    "InvalidParameterException",
    "InvalidParameterTypeException",
    "InvalidParameterValueException",
    "InvalidServiceNameException",
    "InvalidTopicNameException",
    "NameValidationException",
    "NoTypeSupportImportedException",
    "NodeNameNonExistentError",
    "NotInitializedException",
    "ParameterAlreadyDeclaredException",
    "ParameterException",
    "ParameterImmutableException",
    "ParameterNotDeclaredException",
    "ParameterUninitializedException",
    "RCLError",
    "RCLInvalidROSArgsError",
    "ROSInterruptException",
    "TimerCancelledError",
    "UnknownROSArgsError",
]

# ROS's own names end in "Exception".
# ruff: noqa: N818


class NotInitializedException(Exception):
    """`rclpy.init()` has not been called, or shutdown has come since."""

    def __init__(self, message: str | None = None) -> None:
        texts = ["rclpy.init() has not been called", *([message] if message is not None else [])]
        super().__init__(*texts)


class ROSInterruptException(Exception):
    """Shutdown came during a wait that it ends."""

    def __init__(self) -> None:
        super().__init__("rclpy.shutdown() has been called")


class NoTypeSupportImportedException(Exception):
    """The class given as a message type is none."""

    def __init__(self) -> None:
        super().__init__("no type_support imported")


class NameValidationException(Exception):
    """A name that ROS doesn't allow.

    Attributes:
        name_type: What the name was for, e.g. "node name".
        name: The name.
        error_msg: Why it isn't allowed.
        invalid_index: Where in it, from 0.
    """

    def __init__(self, name_type: str, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__(f"Invalid {name_type}: {error_msg}:\n  '{name}'\n   {' ' * invalid_index}^")
        self.name_type = name_type
        self.name = name
        self.error_msg = error_msg
        self.invalid_index = invalid_index


class InvalidNamespaceException(NameValidationException):
    """A namespace that isn't valid."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("namespace", name, error_msg, invalid_index)


class InvalidNodeNameException(NameValidationException):
    """A node's name that isn't valid."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("node name", name, error_msg, invalid_index)


class InvalidTopicNameException(NameValidationException):
    """A topic's name that isn't valid."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("topic name", name, error_msg, invalid_index)


class InvalidServiceNameException(NameValidationException):
    """A service's name that isn't valid."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("service name", name, error_msg, invalid_index)


class ParameterException(Exception):
    """Base of all errors of parameters; `args[1]` holds the name or names."""

    def __init__(self, error_msg: str, parameters: str | list[str], *args: object) -> None:
        super().__init__(f"{error_msg}: {parameters}", parameters, *args)

    def __str__(self) -> str:
        return str(self.args[0])


class ParameterNotDeclaredException(ParameterException):
    """A parameter was read or set that isn't declared."""

    def __init__(self, parameters: str | list[str], *args: object) -> None:
        super().__init__("Invalid access to undeclared parameter(s)", parameters, *args)


class ParameterAlreadyDeclaredException(ParameterException):
    """A parameter was declared twice."""

    def __init__(self, parameters: str | list[str], *args: object) -> None:
        super().__init__("Parameter(s) already declared", parameters, *args)


class InvalidParameterException(ParameterException):
    """A parameter's name isn't valid."""

    def __init__(self, parameter_name: str, *args: object) -> None:
        super().__init__("Invalid parameter name", parameter_name, *args)


class InvalidParameterTypeException(ParameterException):
    """A value of another type than the parameter's was given."""

    def __init__(self, desired_parameter: Parameter, expected_type: object, *args: object) -> None:
        super().__init__(
            f"Trying to set parameter '{desired_parameter.name}' to '{desired_parameter.value}' of type "
            f"'{desired_parameter.type_.name}', expecting type '{expected_type}'",
            desired_parameter.name,
            *args,
        )


class InvalidParameterValueException(ParameterException):
    """A value was refused, by a callback or a declared range."""

    def __init__(self, parameter: str, value: Any, reason: str, *args: object) -> None:
        super().__init__(
            f"Invalid parameter value ({value}) for parameter. Reason: {reason}", parameter, *args
        )


class ParameterImmutableException(ParameterException):
    """A read-only parameter was to be changed or removed."""

    def __init__(self, parameter_name: str, *args: object) -> None:
        super().__init__("Attempted to modify read-only parameter", parameter_name, *args)


class ParameterUninitializedException(ParameterException):
    """A parameter declared with a type and no value was read."""

    def __init__(self, parameter_name: str, *args: object) -> None:
        super().__init__(f"The parameter '{parameter_name}' is not initialized", parameter_name, *args)


class InvalidHandle(Exception):
    """Something was used after its `destroy`."""


class RCLError(RuntimeError):
    """The library below refused, for example because its context is shut down."""


class NodeNameNonExistentError(RCLError):
    """A node was asked about that isn't on the graph."""


class TimerCancelledError(RCLError):
    """A timer was called that is cancelled."""


class RCLInvalidROSArgsError(RCLError):
    """An argument behind `--ros-args` can't be understood."""

    def __init__(self, why: str) -> None:
        super().__init__(f"Failed to parse ROS arguments: {why}")


class UnknownROSArgsError(RuntimeError):
    """Something behind `--ros-args` is no ROS argument."""

    def __init__(self, unknown: list[str]) -> None:
        super().__init__(f"Found unknown ROS arguments: [{', '.join(repr(word) for word in unknown)}]")
        self.unknown = unknown
