"""The hash of a type's definition."""

from tfloom.node.values.type_hash import *
from tfloom.node.values.type_hash import __all__
