"""The variables of loops."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.substitutions.for_loop_var import ForEachVar as ForEachVar
from tfloom.launch.substitutions.for_loop_var import ForLoopIndex as ForLoopIndex
