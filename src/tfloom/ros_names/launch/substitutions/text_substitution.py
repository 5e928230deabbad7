"""A text as a substitution."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.text_substitution import TextSubstitution as TextSubstitution
