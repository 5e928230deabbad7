"""Publishers that publish while their lifecycle node is active."""

from tfloom.node.lifecycle.publisher import *
from tfloom.node.lifecycle.publisher import __all__
