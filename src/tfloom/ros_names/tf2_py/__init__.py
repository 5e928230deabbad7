"""The buffer and its exceptions, without a node."""

from tfloom.ros_guard import claim

claim("tf2_py")

from tfloom.tf2.errors import *
from tfloom.tf2_ros.buffer_core import BufferCore
