"""Errors of parameters.

ParameterException
├── ParameterNotDeclaredException
├── ParameterAlreadyDeclaredException
├── InvalidParameterException       the name is empty
├── InvalidParameterTypeException
├── InvalidParameterValueException
├── ParameterImmutableException
└── ParameterUninitializedException
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tfloom.common.text import shortened
from tfloom.ros_imports.guard import ros_home

if TYPE_CHECKING:
    from tfloom.node.parameters.parameter import Parameter

__all__ = [
    "InvalidParameterException",
    "InvalidParameterTypeException",
    "InvalidParameterValueException",
    "ParameterAlreadyDeclaredException",
    "ParameterException",
    "ParameterImmutableException",
    "ParameterNotDeclaredException",
    "ParameterUninitializedException",
]

# ROS's own names end in "Exception".


class ParameterException(Exception):
    """Base of all errors of parameters; `args[1]` holds the name or names."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, error_msg: str, parameters: str | list[str], *args: object) -> None:
        super().__init__(f"{error_msg}: {parameters}", parameters, *args)

    def __str__(self) -> str:
        return str(self.args[0])


class ParameterNotDeclaredException(ParameterException):
    """An undeclared parameter was read or set."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, parameters: str | list[str], *args: object) -> None:
        super().__init__("Invalid access to undeclared parameter(s)", parameters, *args)


class ParameterAlreadyDeclaredException(ParameterException):
    """A parameter was declared twice."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, parameters: str | list[str], *args: object) -> None:
        super().__init__("Parameter(s) already declared", parameters, *args)


class InvalidParameterException(ParameterException):
    """A parameter's name isn't valid."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, parameter_name: str, *args: object) -> None:
        super().__init__("Invalid parameter name", parameter_name, *args)


class InvalidParameterTypeException(ParameterException):
    """A value of another type than the parameter's was given."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, desired_parameter: Parameter, expected_type: object, *args: object) -> None:
        super().__init__(
            f"Trying to set parameter '{desired_parameter.name}' to '{shortened(desired_parameter.value)}' of type "
            f"'{desired_parameter.type_.name}', expecting type '{expected_type}'",
            desired_parameter.name,
            *args,
        )


class InvalidParameterValueException(ParameterException):
    """A value was rejected by a callback or is outside the declared range."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, parameter: str, value: Any, reason: str, *args: object) -> None:
        super().__init__(
            f"Invalid parameter value ({shortened(value)}) for parameter. Reason: {reason}", parameter, *args
        )


class ParameterImmutableException(ParameterException):
    """A change or removal of a read-only parameter was requested."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, parameter_name: str, *args: object) -> None:
        super().__init__("Attempted to modify read-only parameter", parameter_name, *args)


class ParameterUninitializedException(ParameterException):
    """A parameter declared with a type and no value was read."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, parameter_name: str, *args: object) -> None:
        super().__init__(f"The parameter '{parameter_name}' is not initialized", parameter_name, *args)
