"""A node's health on /diagnostics."""

from tfloom.ros_guard import claim

claim("diagnostic_updater")

from tfloom.node.clock.clock import Clock
from tfloom.node.values.clock_type import ClockType
from tfloom.node.values.time import Time
from tfloom.sensing.diagnosed_publisher import *
from tfloom.sensing.diagnostic_status_wrapper import *
from tfloom.sensing.diagnostic_tasks import *
from tfloom.sensing.diagnostic_updater import *
from tfloom.sensing.update_functions import *
