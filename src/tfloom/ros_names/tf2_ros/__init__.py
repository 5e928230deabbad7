"""Buffers, listeners and broadcasters for the transforms on /tf and /tf_static."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.ros_guard import claim

claim("tf2_ros")

from tfloom.tf2.errors import BackwardExtrapolationException as BackwardExtrapolationException
from tfloom.tf2.errors import ForwardExtrapolationException as ForwardExtrapolationException
from tfloom.tf2.errors import NoDataForExtrapolationException as NoDataForExtrapolationException
from tfloom.tf2_ros.buffer import Buffer as Buffer
from tfloom.tf2_ros.buffer_client import BufferClient as BufferClient
from tfloom.tf2_ros.buffer_interface import BufferInterface as BufferInterface
from tfloom.tf2_ros.buffer_interface import ConvertRegistration as ConvertRegistration
from tfloom.tf2_ros.buffer_interface import NotImplementedException as NotImplementedException
from tfloom.tf2_ros.buffer_interface import Stamped as Stamped
from tfloom.tf2_ros.buffer_interface import TransformRegistration as TransformRegistration
from tfloom.tf2_ros.buffer_interface import TypeException as TypeException
from tfloom.tf2_ros.buffer_interface import convert as convert
from tfloom.tf2_ros.buffer_server import BufferServer as BufferServer
from tfloom.tf2_ros.message_filter import FilterFailureReason as FilterFailureReason
from tfloom.tf2_ros.message_filter import MessageFilter as MessageFilter
from tfloom.tf2_ros.message_filter import get_filter_failure_reason_string as get_filter_failure_reason_string
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster as StaticTransformBroadcaster
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster as TransformBroadcaster
from tfloom.tf2_ros.transform_listener import DEFAULT_STATIC_TF_TOPIC as DEFAULT_STATIC_TF_TOPIC
from tfloom.tf2_ros.transform_listener import DEFAULT_TF_TOPIC as DEFAULT_TF_TOPIC
from tfloom.tf2_ros.transform_listener import StaticTransformListener as StaticTransformListener
from tfloom.tf2_ros.transform_listener import TransformListener as TransformListener

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tf2_ros import buffer as buffer
    from tf2_ros import buffer_client as buffer_client
    from tf2_ros import buffer_interface as buffer_interface
    from tf2_ros import buffer_server as buffer_server
    from tf2_ros import message_filter as message_filter
    from tf2_ros import static_transform_broadcaster as static_transform_broadcaster
    from tf2_ros import static_transform_listener as static_transform_listener
    from tf2_ros import transform_broadcaster as transform_broadcaster
    from tf2_ros import transform_listener as transform_listener
    from tfloom.c_libraries import add_dll_directories_from_env as add_dll_directories_from_env
    from tfloom.interfaces.geometry_msgs.msg import PointStamped as PointStamped
    from tfloom.interfaces.geometry_msgs.msg import PoseStamped as PoseStamped
    from tfloom.interfaces.geometry_msgs.msg import PoseWithCovarianceStamped as PoseWithCovarianceStamped
    from tfloom.interfaces.geometry_msgs.msg import TransformStamped as TransformStamped
    from tfloom.interfaces.geometry_msgs.msg import Vector3Stamped as Vector3Stamped
    from tfloom.interfaces.sensor_msgs.msg import PointCloud2 as PointCloud2
    from tfloom.interfaces.std_msgs.msg import Header as Header
    from tfloom.interfaces.tf2_msgs.action import LookupTransform as LookupTransform
    from tfloom.interfaces.tf2_msgs.msg import TFMessage as TFMessage
    from tfloom.interfaces.tf2_msgs.srv import FrameGraph as FrameGraph
    from tfloom.node.action.client import ActionClient as ActionClient
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
    from tfloom.tf2.errors import ConnectivityException as ConnectivityException
    from tfloom.tf2.errors import ExtrapolationException as ExtrapolationException
    from tfloom.tf2.errors import InvalidArgumentException as InvalidArgumentException
    from tfloom.tf2.errors import LookupException as LookupException
    from tfloom.tf2.errors import TimeoutException as TimeoutException
    from tfloom.tf2.errors import TransformException as TransformException
    from tfloom.tf2_ros.annotation_types import FrameGraphSrvRequest as FrameGraphSrvRequest
    from tfloom.tf2_ros.annotation_types import FrameGraphSrvResponse as FrameGraphSrvResponse
    from tfloom.tf2_ros.annotation_types import LookupTransformGoal as LookupTransformGoal
    from tfloom.tf2_ros.annotation_types import LookupTransformResult as LookupTransformResult
    from tfloom.tf2_ros.annotation_types import MsgStamped as MsgStamped
    from tfloom.tf2_ros.annotation_types import PyKDLType as PyKDLType
    from tfloom.tf2_ros.annotation_types import TransformableObject as TransformableObject
    from tfloom.tf2_ros.annotation_types import TransformableObjectType as TransformableObjectType
    from tfloom.tf2_ros.buffer_core import BufferCore as BufferCore
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ActionClient="tfloom.node.action.client",
        BufferCore="tfloom.tf2_ros.buffer_core",
        Clock="tfloom.node.clock.clock",
        ConnectivityException="tfloom.tf2.errors",
        DurabilityPolicy="tfloom.node.qos.qos",
        Duration="tfloom.node.values.duration",
        ExtrapolationException="tfloom.tf2.errors",
        FrameGraph="tfloom.interfaces.tf2_msgs.srv",
        FrameGraphSrvRequest="tfloom.tf2_ros.annotation_types",
        FrameGraphSrvResponse="tfloom.tf2_ros.annotation_types",
        Future="tfloom.node.executing.task",
        Header="tfloom.interfaces.std_msgs.msg",
        HistoryPolicy="tfloom.node.qos.qos",
        InvalidArgumentException="tfloom.tf2.errors",
        JumpThreshold="tfloom.node.clock.time_jump",
        LookupException="tfloom.tf2.errors",
        LookupTransform="tfloom.interfaces.tf2_msgs.action",
        LookupTransformGoal="tfloom.tf2_ros.annotation_types",
        LookupTransformResult="tfloom.tf2_ros.annotation_types",
        MsgStamped="tfloom.tf2_ros.annotation_types",
        Node="tfloom.node.node",
        PointCloud2="tfloom.interfaces.sensor_msgs.msg",
        PointStamped="tfloom.interfaces.geometry_msgs.msg",
        PoseStamped="tfloom.interfaces.geometry_msgs.msg",
        PoseWithCovarianceStamped="tfloom.interfaces.geometry_msgs.msg",
        PyKDLType="tfloom.tf2_ros.annotation_types",
        QoSProfile="tfloom.node.qos.qos",
        ReentrantCallbackGroup="tfloom.node.executing.callback_groups",
        SingleThreadedExecutor="tfloom.node.executing.executors",
        TFMessage="tfloom.interfaces.tf2_msgs.msg",
        Time="tfloom.node.values.time",
        TimeJump="tfloom.node.clock.time_jump",
        TimeoutException="tfloom.tf2.errors",
        TransformException="tfloom.tf2.errors",
        TransformStamped="tfloom.interfaces.geometry_msgs.msg",
        TransformableObject="tfloom.tf2_ros.annotation_types",
        TransformableObjectType="tfloom.tf2_ros.annotation_types",
        Vector3Stamped="tfloom.interfaces.geometry_msgs.msg",
        add_dll_directories_from_env="tfloom.c_libraries",
        buffer="tf2_ros",
        buffer_client="tf2_ros",
        buffer_interface="tf2_ros",
        buffer_server="tf2_ros",
        message_filter="tf2_ros",
        static_transform_broadcaster="tf2_ros",
        static_transform_listener="tf2_ros",
        transform_broadcaster="tf2_ros",
        transform_listener="tf2_ros",
    )
