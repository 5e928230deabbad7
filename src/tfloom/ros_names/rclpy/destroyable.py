"""The type of objects that are destroyed when they are not in use."""

from tfloom.node.values.destroyable import *
from tfloom.node.values.destroyable import __all__
