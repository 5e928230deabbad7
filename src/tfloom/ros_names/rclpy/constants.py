"""Constants of time."""

from tfloom.node.values.constants import S_TO_NS

__all__ = ["S_TO_NS"]
