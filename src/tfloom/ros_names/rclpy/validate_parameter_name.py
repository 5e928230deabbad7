"""Validation of parameter names."""

from tfloom.node.parameters.exceptions import InvalidParameterException as InvalidParameterException
from tfloom.node.parameters.validate_parameter_name import validate_parameter_name as validate_parameter_name
