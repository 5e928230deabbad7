"""Fill a buffer from /tf and /tf_static."""

from tfloom.interfaces.tf2_msgs.msg import TFMessage as TFMessage
from tfloom.node.executing.callback_groups import ReentrantCallbackGroup as ReentrantCallbackGroup
from tfloom.node.executing.executors import SingleThreadedExecutor as SingleThreadedExecutor
from tfloom.node.node import Node as Node
from tfloom.node.qos.qos import DurabilityPolicy as DurabilityPolicy
from tfloom.node.qos.qos import HistoryPolicy as HistoryPolicy
from tfloom.node.qos.qos import QoSProfile as QoSProfile
from tfloom.tf2_ros.buffer import Buffer as Buffer
from tfloom.tf2_ros.transform_listener import *
