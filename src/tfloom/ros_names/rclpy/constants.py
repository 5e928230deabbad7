"""Numbers that many files share."""

from tfloom.node.values.constants import S_TO_NS

__all__ = ["S_TO_NS"]
