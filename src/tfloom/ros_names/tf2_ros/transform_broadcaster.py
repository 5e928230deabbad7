"""Publish transforms on /tf."""

from tfloom.interfaces.geometry_msgs.msg import TransformStamped as TransformStamped
from tfloom.interfaces.tf2_msgs.msg import TFMessage as TFMessage
from tfloom.node.node import Node as Node
from tfloom.node.qos.qos import QoSProfile as QoSProfile
from tfloom.tf2_ros.transform_broadcaster import *
