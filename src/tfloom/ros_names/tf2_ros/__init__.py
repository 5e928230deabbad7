"""Buffers, listeners and broadcasters for the transforms on /tf and /tf_static."""

from typing import TYPE_CHECKING

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
from tfloom.interfaces.geometry_msgs.msg import PointStamped as PointStamped
from tfloom.interfaces.geometry_msgs.msg import PoseStamped as PoseStamped
from tfloom.interfaces.geometry_msgs.msg import PoseWithCovarianceStamped as PoseWithCovarianceStamped
from tfloom.interfaces.geometry_msgs.msg import TransformStamped as TransformStamped
from tfloom.interfaces.geometry_msgs.msg import Vector3Stamped as Vector3Stamped
from tfloom.interfaces.std_msgs.msg import Header as Header
from tfloom.interfaces.tf2_msgs.msg import TFMessage as TFMessage
from tfloom.interfaces.tf2_msgs.srv import FrameGraph as FrameGraph
from tfloom.node.clock.clock import Clock as Clock
from tfloom.node.clock.time_jump import JumpThreshold as JumpThreshold
from tfloom.node.clock.time_jump import TimeJump as TimeJump
from tfloom.node.executing.callback_groups import ReentrantCallbackGroup as ReentrantCallbackGroup
from tfloom.node.executing.executors import SingleThreadedExecutor as SingleThreadedExecutor
from tfloom.node.executing.task import Future as Future
from tfloom.node.node import Node as Node
from tfloom.node.qos.qos import DurabilityPolicy as DurabilityPolicy
from tfloom.node.qos.qos import HistoryPolicy as HistoryPolicy
from tfloom.node.qos.qos import QoSProfile as QoSProfile
from tfloom.node.values.duration import Duration as Duration
from tfloom.node.values.time import Time as Time
from tfloom.tf2.errors import *
from tfloom.tf2_ros.buffer import *
from tfloom.tf2_ros.buffer_client import *
from tfloom.tf2_ros.buffer_core import BufferCore as BufferCore
from tfloom.tf2_ros.buffer_interface import *
from tfloom.tf2_ros.buffer_server import *
from tfloom.tf2_ros.message_filter import *
from tfloom.tf2_ros.static_transform_broadcaster import *
from tfloom.tf2_ros.transform_broadcaster import *
from tfloom.tf2_ros.transform_listener import *

if TYPE_CHECKING:
    from tfloom.c_libraries import add_dll_directories_from_env as add_dll_directories_from_env
    from tfloom.interfaces.sensor_msgs.msg import PointCloud2 as PointCloud2
    from tfloom.interfaces.tf2_msgs.action import LookupTransform as LookupTransform
    from tfloom.node.action.client import ActionClient as ActionClient
    from tfloom.tf2_ros.annotation_types import FrameGraphSrvRequest as FrameGraphSrvRequest
    from tfloom.tf2_ros.annotation_types import FrameGraphSrvResponse as FrameGraphSrvResponse
    from tfloom.tf2_ros.annotation_types import LookupTransformGoal as LookupTransformGoal
    from tfloom.tf2_ros.annotation_types import LookupTransformResult as LookupTransformResult
    from tfloom.tf2_ros.annotation_types import MsgStamped as MsgStamped
    from tfloom.tf2_ros.annotation_types import PyKDLType as PyKDLType
    from tfloom.tf2_ros.annotation_types import TransformableObject as TransformableObject
    from tfloom.tf2_ros.annotation_types import TransformableObjectType as TransformableObjectType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        add_dll_directories_from_env="tfloom.c_libraries",
        PointCloud2="tfloom.interfaces.sensor_msgs.msg",
        LookupTransform="tfloom.interfaces.tf2_msgs.action",
        ActionClient="tfloom.node.action.client",
        FrameGraphSrvRequest="tfloom.tf2_ros.annotation_types",
        FrameGraphSrvResponse="tfloom.tf2_ros.annotation_types",
        LookupTransformGoal="tfloom.tf2_ros.annotation_types",
        LookupTransformResult="tfloom.tf2_ros.annotation_types",
        MsgStamped="tfloom.tf2_ros.annotation_types",
        PyKDLType="tfloom.tf2_ros.annotation_types",
        TransformableObject="tfloom.tf2_ros.annotation_types",
        TransformableObjectType="tfloom.tf2_ros.annotation_types",
    )
