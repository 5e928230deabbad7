"""Nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.node import HIDDEN_NODE_PREFIX as HIDDEN_NODE_PREFIX
from tfloom.node.node import MsgType as MsgType
from tfloom.node.node import Node as Node
from tfloom.node.node import PARAMETER_SEPARATOR_STRING as PARAMETER_SEPARATOR_STRING
from tfloom.node.node import S_TO_NS as S_TO_NS
from tfloom.node.node import SrvType as SrvType
from tfloom.node.node import SrvTypeRequest as SrvTypeRequest
from tfloom.node.node import SrvTypeResponse as SrvTypeResponse

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.rcl_interfaces.msg import FloatingPointRange as FloatingPointRange
    from tfloom.interfaces.rcl_interfaces.msg import IntegerRange as IntegerRange
    from tfloom.interfaces.rcl_interfaces.msg import ListParametersResult as ListParametersResult
    from tfloom.interfaces.rcl_interfaces.msg import ParameterDescriptor as ParameterDescriptor
    from tfloom.interfaces.rcl_interfaces.msg import ParameterEvent as ParameterEvent
    from tfloom.interfaces.rcl_interfaces.msg import ParameterType as ParameterType
    from tfloom.interfaces.rcl_interfaces.msg import ParameterValue as ParameterValue
    from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult as SetParametersResult
    from tfloom.interfaces.rcl_interfaces.srv import ListParameters as ListParameters
    from tfloom.node.builtin.logging_service import LoggingService as LoggingService
    from tfloom.node.builtin.parameter_service import ParameterService as ParameterService
    from tfloom.node.builtin.time_source import TimeSource as TimeSource
    from tfloom.node.builtin.type_description_service import TypeDescriptionService as TypeDescriptionService
    from tfloom.node.clock.clock import Clock as Clock
    from tfloom.node.clock.clock import ROSClock as ROSClock
    from tfloom.node.context.context import Context as Context
    from tfloom.node.context.utilities import get_default_context as get_default_context
    from tfloom.node.endpoints.client import Client as Client
    from tfloom.node.endpoints.publisher import Publisher as Publisher
    from tfloom.node.endpoints.service import Service as Service
    from tfloom.node.endpoints.subscription import Subscription as Subscription
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup as MutuallyExclusiveCallbackGroup
    from tfloom.node.executing.callback_groups import ReentrantCallbackGroup as ReentrantCallbackGroup
    from tfloom.node.executing.event_handler import PublisherEventCallbacks as PublisherEventCallbacks
    from tfloom.node.executing.event_handler import SubscriptionEventCallbacks as SubscriptionEventCallbacks
    from tfloom.node.executing.executor import Executor as Executor
    from tfloom.node.executing.guard_condition import GuardCondition as GuardCondition
    from tfloom.node.executing.timer import Rate as Rate
    from tfloom.node.executing.timer import Timer as Timer
    from tfloom.node.executing.waitable import Waitable as Waitable
    from tfloom.node.log.logging import get_logger as get_logger
    from tfloom.node.parameters.exceptions import InvalidParameterTypeException as InvalidParameterTypeException
    from tfloom.node.parameters.exceptions import InvalidParameterValueException as InvalidParameterValueException
    from tfloom.node.parameters.exceptions import ParameterAlreadyDeclaredException as ParameterAlreadyDeclaredException
    from tfloom.node.parameters.exceptions import ParameterImmutableException as ParameterImmutableException
    from tfloom.node.parameters.exceptions import ParameterNotDeclaredException as ParameterNotDeclaredException
    from tfloom.node.parameters.exceptions import ParameterUninitializedException as ParameterUninitializedException
    from tfloom.node.parameters.parameter import Parameter as Parameter
    from tfloom.node.parameters.parameter import ParameterMsg as ParameterMsg
    from tfloom.node.parameters.validate_parameter_name import validate_parameter_name as validate_parameter_name
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
    from tfloom.node.qos.qos import qos_profile_parameter_events as qos_profile_parameter_events
    from tfloom.node.qos.qos import qos_profile_services_default as qos_profile_services_default
    from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions as QoSOverridingOptions
    from tfloom.node.qos.topic_endpoint_info import TopicEndpointInfo as TopicEndpointInfo
    from tfloom.node.values.exceptions import InvalidHandle as InvalidHandle
    from tfloom.node.values.exceptions import NodeNameNonExistentError as NodeNameNonExistentError
    from tfloom.node.values.exceptions import NotInitializedException as NotInitializedException
    from tfloom.node.values.names import InvalidTopicNameException as InvalidTopicNameException
    from tfloom.node.values.names import expand_topic_name as expand_topic_name
    from tfloom.node.values.names import validate_full_topic_name as validate_full_topic_name
    from tfloom.node.values.names import validate_namespace as validate_namespace
    from tfloom.node.values.names import validate_node_name as validate_node_name
    from tfloom.node.values.names import validate_topic_name as validate_topic_name
    from tfloom.node.values.type_support import check_is_valid_msg_type as check_is_valid_msg_type
    from tfloom.node.values.type_support import check_is_valid_srv_type as check_is_valid_srv_type
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
        Client="tfloom.node.endpoints.client",
        Clock="tfloom.node.clock.clock",
        Context="tfloom.node.context.context",
        Executor="tfloom.node.executing.executor",
        FloatingPointRange="tfloom.interfaces.rcl_interfaces.msg",
        GuardCondition="tfloom.node.executing.guard_condition",
        IntegerRange="tfloom.interfaces.rcl_interfaces.msg",
        InvalidHandle="tfloom.node.values.exceptions",
        InvalidParameterTypeException="tfloom.node.parameters.exceptions",
        InvalidParameterValueException="tfloom.node.parameters.exceptions",
        InvalidTopicNameException="tfloom.node.values.names",
        ListParameters="tfloom.interfaces.rcl_interfaces.srv",
        ListParametersResult="tfloom.interfaces.rcl_interfaces.msg",
        LoggingService="tfloom.node.builtin.logging_service",
        MutuallyExclusiveCallbackGroup="tfloom.node.executing.callback_groups",
        NodeNameNonExistentError="tfloom.node.values.exceptions",
        NotInitializedException="tfloom.node.values.exceptions",
        Parameter="tfloom.node.parameters.parameter",
        ParameterAlreadyDeclaredException="tfloom.node.parameters.exceptions",
        ParameterDescriptor="tfloom.interfaces.rcl_interfaces.msg",
        ParameterEvent="tfloom.interfaces.rcl_interfaces.msg",
        ParameterImmutableException="tfloom.node.parameters.exceptions",
        ParameterMsg="tfloom.node.parameters.parameter",
        ParameterNotDeclaredException="tfloom.node.parameters.exceptions",
        ParameterService="tfloom.node.builtin.parameter_service",
        ParameterType="tfloom.interfaces.rcl_interfaces.msg",
        ParameterUninitializedException="tfloom.node.parameters.exceptions",
        ParameterValue="tfloom.interfaces.rcl_interfaces.msg",
        Publisher="tfloom.node.endpoints.publisher",
        PublisherEventCallbacks="tfloom.node.executing.event_handler",
        QoSOverridingOptions="tfloom.node.qos.qos_overriding_options",
        QoSProfile="tfloom.node.qos.qos",
        ROSClock="tfloom.node.clock.clock",
        Rate="tfloom.node.executing.timer",
        ReentrantCallbackGroup="tfloom.node.executing.callback_groups",
        Service="tfloom.node.endpoints.service",
        SetParametersResult="tfloom.interfaces.rcl_interfaces.msg",
        Subscription="tfloom.node.endpoints.subscription",
        SubscriptionEventCallbacks="tfloom.node.executing.event_handler",
        TimeSource="tfloom.node.builtin.time_source",
        Timer="tfloom.node.executing.timer",
        TopicEndpointInfo="tfloom.node.qos.topic_endpoint_info",
        TypeDescriptionService="tfloom.node.builtin.type_description_service",
        Waitable="tfloom.node.executing.waitable",
        check_is_valid_msg_type="tfloom.node.values.type_support",
        check_is_valid_srv_type="tfloom.node.values.type_support",
        expand_topic_name="tfloom.node.values.names",
        get_default_context="tfloom.node.context.utilities",
        get_logger="tfloom.node.log.logging",
        qos_profile_parameter_events="tfloom.node.qos.qos",
        qos_profile_services_default="tfloom.node.qos.qos",
        validate_full_topic_name="tfloom.node.values.names",
        validate_namespace="tfloom.node.values.names",
        validate_node_name="tfloom.node.values.names",
        validate_parameter_name="tfloom.node.parameters.validate_parameter_name",
        validate_topic_name="tfloom.node.values.names",
    )
