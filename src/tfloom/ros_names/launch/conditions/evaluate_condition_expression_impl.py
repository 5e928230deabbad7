"""The truth value of a condition's text."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.conditions.evaluate_condition_expression_impl import VALID_FALSE_EXPRESSIONS as VALID_FALSE_EXPRESSIONS
from tfloom.launch.conditions.evaluate_condition_expression_impl import VALID_TRUE_EXPRESSIONS as VALID_TRUE_EXPRESSIONS
from tfloom.launch.conditions.evaluate_condition_expression_impl import evaluate_condition_expression as evaluate_condition_expression
