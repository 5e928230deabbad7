"""Validation of parameter names."""

from tfloom.node.parameters.validate_parameter_name import validate_parameter_name

__all__ = ["validate_parameter_name"]
