"""The service of types."""

from tfloom.node.type_description_service import *
from tfloom.node.type_description_service import __all__
