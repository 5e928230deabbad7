"""What can be destroyed."""

from tfloom.node.destroyable import *
from tfloom.node.destroyable import __all__
