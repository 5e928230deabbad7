"""Paths of several parts."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.path_join_substitution import PathJoinSubstitution as PathJoinSubstitution
from tfloom.launch.substitutions.path_join_substitution import PathSubstitution as PathSubstitution
