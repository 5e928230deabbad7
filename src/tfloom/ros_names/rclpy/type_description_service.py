"""The service of types."""

from tfloom.node.builtin.type_description_service import *
from tfloom.node.builtin.type_description_service import __all__
