"""Repeat actions."""

from tfloom.launch.actions.for_loop import ForEach as ForEach
from tfloom.launch.actions.for_loop import ForLoop as ForLoop
