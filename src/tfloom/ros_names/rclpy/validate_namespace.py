"""Validation of namespaces."""

from tfloom.node.values.names import validate_namespace

__all__ = ["validate_namespace"]
