"""The kinds of clocks."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.clock_type import ClockType as ClockType
