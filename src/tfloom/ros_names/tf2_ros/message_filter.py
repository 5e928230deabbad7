"""Keep messages until they can be transformed."""

from tfloom.tf2_ros.message_filter import *
from tfloom.tf2_ros.message_filter import __all__
