"""Validation of node names."""

from tfloom.node.values.names import InvalidNodeNameException as InvalidNodeNameException
from tfloom.node.values.names import validate_node_name as validate_node_name
