"""The error of a substitution that has no text."""

from tfloom.launch.substitutions.substitution_failure import *
