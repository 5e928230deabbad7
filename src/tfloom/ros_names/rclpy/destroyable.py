"""What can be destroyed."""

from tfloom.node.values.destroyable import *
from tfloom.node.values.destroyable import __all__
