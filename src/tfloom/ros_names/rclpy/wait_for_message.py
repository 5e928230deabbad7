"""Wait for one message of a topic."""

from tfloom.node.wait_for_message import *
from tfloom.node.wait_for_message import __all__
