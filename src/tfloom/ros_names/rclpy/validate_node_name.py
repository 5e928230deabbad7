"""What is valid as a node's name."""

from tfloom.node.values.names import validate_node_name

__all__ = ["validate_node_name"]
