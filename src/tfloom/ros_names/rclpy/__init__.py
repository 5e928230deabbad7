"""The client library of ROS 2, on tfloom."""

from tfloom.node import *
from tfloom.node import __all__
