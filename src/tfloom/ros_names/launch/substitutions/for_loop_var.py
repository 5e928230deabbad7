"""The variables of loops."""

from tfloom.launch.substitutions.for_loop_var import *
