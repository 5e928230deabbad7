"""Frames over time, on /tf and /tf_static."""

from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.time import Time
from std_msgs.msg import Header
from tf2_py import *

from tf2_ros.buffer import *
from tf2_ros.buffer_interface import *
from tf2_ros.static_transform_broadcaster import *
from tf2_ros.transform_broadcaster import *
from tf2_ros.transform_listener import *
