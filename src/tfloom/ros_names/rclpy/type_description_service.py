"""The service that returns the definitions of a node's types."""

from tfloom.node.builtin.type_description_service import *
from tfloom.node.builtin.type_description_service import __all__
