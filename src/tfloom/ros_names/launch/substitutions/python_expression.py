"""The value of a Python expression."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.python_expression import PythonExpression as PythonExpression
