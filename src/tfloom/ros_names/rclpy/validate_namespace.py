"""What is valid as a namespace."""

from tfloom.node.values.names import validate_namespace

__all__ = ["validate_namespace"]
