"""Whether two texts differ."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.not_equals_substitution import NotEqualsSubstitution as NotEqualsSubstitution
