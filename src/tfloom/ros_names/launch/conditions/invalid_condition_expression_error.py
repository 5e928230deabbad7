"""The error of a condition that is neither true nor false."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.conditions.invalid_condition_expression_error import InvalidConditionExpressionError as InvalidConditionExpressionError
