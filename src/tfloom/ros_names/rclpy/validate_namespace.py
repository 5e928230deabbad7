"""What is valid as a namespace."""

from tfloom.node.values.names import InvalidNamespaceException as InvalidNamespaceException
from tfloom.node.values.names import validate_namespace as validate_namespace
