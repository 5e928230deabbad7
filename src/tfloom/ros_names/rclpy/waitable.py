"""Base class of a program's own waitables."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.executing.waitable import NumberOfEntities as NumberOfEntities
from tfloom.node.executing.waitable import Waitable as Waitable
