"""One of two texts."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.if_else_substitution import IfElseSubstitution as IfElseSubstitution
