"""Texts joined by a delimiter."""

from tfloom.launch.substitutions.string_join_substitution import *
