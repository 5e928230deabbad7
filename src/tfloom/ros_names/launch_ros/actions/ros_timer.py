"""The action that waits by ROS's time, then executes others."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.actions.ros_timer import ROSTimer as ROSTimer
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple
