"""Whether two texts are equal."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.equals_substitution import EqualsSubstitution as EqualsSubstitution
