"""Validation of node names."""

from tfloom.node.values.names import validate_node_name

__all__ = ["validate_node_name"]
