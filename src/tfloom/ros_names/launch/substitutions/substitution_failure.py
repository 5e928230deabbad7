"""The error of a substitution that has no text."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure as SubstitutionFailure
