"""Buffers, listeners and broadcasters for the transforms on /tf and /tf_static."""

from tfloom.ros_guard import claim

claim("tf2_ros")

import tf2_ros.buffer
import tf2_ros.buffer_client
import tf2_ros.buffer_interface
import tf2_ros.buffer_server
import tf2_ros.message_filter
import tf2_ros.static_transform_broadcaster
import tf2_ros.static_transform_listener
import tf2_ros.transform_broadcaster
import tf2_ros.transform_listener
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time
from tfloom.tf2.errors import *
from tfloom.tf2_ros.buffer import *
from tfloom.tf2_ros.buffer_client import *
from tfloom.tf2_ros.buffer_core import BufferCore
from tfloom.tf2_ros.buffer_interface import *
from tfloom.tf2_ros.buffer_server import *
from tfloom.tf2_ros.message_filter import *
from tfloom.tf2_ros.static_transform_broadcaster import *
from tfloom.tf2_ros.transform_broadcaster import *
from tfloom.tf2_ros.transform_listener import *
