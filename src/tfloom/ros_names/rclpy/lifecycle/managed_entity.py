"""What goes along with such nodes."""

from tfloom.node.lifecycle.managed_entity import *
from tfloom.node.lifecycle.managed_entity import __all__
