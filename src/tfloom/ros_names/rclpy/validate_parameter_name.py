"""What is valid as a parameter's name."""

from tfloom.node.parameters.validate_parameter_name import validate_parameter_name

__all__ = ["validate_parameter_name"]
