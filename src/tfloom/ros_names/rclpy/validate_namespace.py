"""Validation of namespaces."""

from tfloom.node.values.names import InvalidNamespaceException as InvalidNamespaceException
from tfloom.node.values.names import validate_namespace as validate_namespace
