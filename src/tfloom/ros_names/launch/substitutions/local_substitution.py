"""The value of a variable of the context."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.local_substitution import LocalSubstitution as LocalSubstitution
