"""Numbers that many files share."""

from tfloom.node.constants import S_TO_NS

__all__ = ["S_TO_NS"]
