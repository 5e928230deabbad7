"""Checks of a parameter's value against its descriptor."""

from __future__ import annotations

from math import isclose

from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node.parameters.parameter import Parameter, ParameterType

__all__ = ["check_against_descriptor"]

RELATIVE_TOLERANCE = 1e-6
"""Relative tolerance of floating-point values at steps and ends of a range."""


def check_against_descriptor(
    parameter: Parameter, descriptor: rcl_msg.ParameterDescriptor, *, check_read_only: bool = True
) -> str | None:
    """Return why a descriptor doesn't allow a value; None if it does."""
    if check_read_only and descriptor.read_only:
        return f"Trying to set a read-only parameter: {parameter.name}."
    if descriptor.dynamic_typing or parameter.type_.value == descriptor.type:
        return _check_range(parameter, descriptor)
    if parameter.type_ is ParameterType.NOT_SET:
        return "Static parameter cannot be undeclared"
    return f"Wrong parameter type, expected '{ParameterType(descriptor.type)}' got '{parameter.type_}'"


def _check_range(parameter: Parameter, descriptor: rcl_msg.ParameterDescriptor) -> str | None:
    if parameter.type_ is ParameterType.INTEGER and descriptor.integer_range:
        return _check_integer(parameter, descriptor.integer_range[0])
    if parameter.type_ is ParameterType.DOUBLE and descriptor.floating_point_range:
        return _check_double(parameter, descriptor.floating_point_range[0])
    return None


def _check_integer(parameter: Parameter, limits: rcl_msg.IntegerRange) -> str | None:
    low, high = sorted((limits.from_value, limits.to_value))
    value = parameter.value
    if value in (low, high):
        return None
    if not low < value < high:
        return _out_of_range(parameter, low, high, "out of range.")
    if limits.step != 0 and (value - low) % limits.step != 0:
        return _off_step(parameter, low, high, limits.step, "a valid step")
    return None


def _check_double(parameter: Parameter, limits: rcl_msg.FloatingPointRange) -> str | None:
    low, high = sorted((limits.from_value, limits.to_value))
    value = parameter.value
    if isclose(value, low, rel_tol=RELATIVE_TOLERANCE) or isclose(value, high, rel_tol=RELATIVE_TOLERANCE):
        return None
    if not low < value < high:
        return _out_of_range(parameter, low, high, "out of range")
    if limits.step != 0.0:
        distance = round((value - low) / limits.step) * limits.step
        if not isclose(value - low, distance, rel_tol=RELATIVE_TOLERANCE):
            return _off_step(parameter, low, high, limits.step, "close enough to a valid step")
    return None


# The texts of rclpy differ in these words between whole numbers and floats.


def _out_of_range(parameter: Parameter, low: float, high: float, what: str) -> str:
    return f"Parameter {parameter.name} {what} Min: {low}, Max: {high}, value: {parameter.value}"


def _off_step(parameter: Parameter, low: float, high: float, step: float, what: str) -> str:
    return (
        f"The parameter value for {parameter.name} is not {what}. "
        f"Min: {low}, max: {high}, value: {parameter.value}, step: {step}"
    )
