"""Publish static transforms on /tf_static."""

from tfloom.interfaces.geometry_msgs.msg import TransformStamped as TransformStamped
from tfloom.interfaces.tf2_msgs.msg import TFMessage as TFMessage
from tfloom.node.node import Node as Node
from tfloom.node.qos.qos import DurabilityPolicy as DurabilityPolicy
from tfloom.node.qos.qos import HistoryPolicy as HistoryPolicy
from tfloom.node.qos.qos import QoSProfile as QoSProfile
from tfloom.tf2_ros.static_transform_broadcaster import *
