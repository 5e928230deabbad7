"""Durations."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.values.duration import Duration as Duration
from tfloom.node.values.duration import DurationType as DurationType
from tfloom.node.values.duration import Infinite as Infinite
from tfloom.node.values.duration import S_TO_NS as S_TO_NS
