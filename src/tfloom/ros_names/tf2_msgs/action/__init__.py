"""The actions of tf2_msgs."""

from tfloom.interfaces.tf2_msgs.action import *
from tfloom.interfaces.tf2_msgs.action import __all__
