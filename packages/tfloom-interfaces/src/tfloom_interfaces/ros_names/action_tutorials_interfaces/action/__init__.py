"""The actions of action_tutorials_interfaces."""

from tfloom_interfaces.interfaces.action_tutorials_interfaces.action import *
from tfloom_interfaces.interfaces.action_tutorials_interfaces.action import __all__
