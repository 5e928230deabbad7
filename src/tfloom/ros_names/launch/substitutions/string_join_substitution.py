"""Texts joined by a delimiter."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.string_join_substitution import StringJoinSubstitution as StringJoinSubstitution
