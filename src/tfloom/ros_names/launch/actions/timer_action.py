"""Wait, then visit actions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.timer_action import TimerAction as TimerAction
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple
