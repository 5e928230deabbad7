"""An element of a launch file, and the parser as actions need it."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.frontend.entity import Entity as Entity
from tfloom.launch.frontend.entity import ParsesActions as ParsesActions
from tfloom.launch.frontend.entity import TargetType as TargetType
