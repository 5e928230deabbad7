"""Publishers of such nodes."""

from tfloom.node.lifecycle.publisher import *
from tfloom.node.lifecycle.publisher import __all__
