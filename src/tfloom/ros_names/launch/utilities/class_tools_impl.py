"""Whether an object or a class is of a kind."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.utilities.class_tools import is_a as is_a
from tfloom.launch.utilities.class_tools import is_a_subclass as is_a_subclass
from tfloom.launch.utilities.class_tools import isclassinstance as isclassinstance
