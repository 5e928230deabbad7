"""Repeat actions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.for_loop import ForEach as ForEach
from tfloom.launch.actions.for_loop import ForLoop as ForLoop
