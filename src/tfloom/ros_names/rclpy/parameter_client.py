"""Clients for the parameters of another node."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.builtin.parameter_client import AsyncParameterClient as AsyncParameterClient

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.rcl_interfaces.msg import ParameterEvent as ParameterEvent
    from tfloom.interfaces.rcl_interfaces.srv import DescribeParameters as DescribeParameters
    from tfloom.interfaces.rcl_interfaces.srv import GetParameterTypes as GetParameterTypes
    from tfloom.interfaces.rcl_interfaces.srv import GetParameters as GetParameters
    from tfloom.interfaces.rcl_interfaces.srv import ListParameters as ListParameters
    from tfloom.interfaces.rcl_interfaces.srv import SetParameters as SetParameters
    from tfloom.interfaces.rcl_interfaces.srv import SetParametersAtomically as SetParametersAtomically
    from tfloom.node.endpoints.subscription import Subscription as Subscription
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.executing.event_handler import SubscriptionEventCallbacks as SubscriptionEventCallbacks
    from tfloom.node.executing.task import Future as Future
    from tfloom.node.node import Node as Node
    from tfloom.node.parameters.parameter import Parameter as Parameter
    from tfloom.node.parameters.parameter import ParameterMsg as ParameterMsg
    from tfloom.node.parameters.parameter import parameter_dict_from_yaml_file as parameter_dict_from_yaml_file
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
    from tfloom.node.qos.qos import qos_profile_parameter_events as qos_profile_parameter_events
    from tfloom.node.qos.qos import qos_profile_services_default as qos_profile_services_default
    from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions as QoSOverridingOptions
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
        DescribeParameters="tfloom.interfaces.rcl_interfaces.srv",
        Future="tfloom.node.executing.task",
        GetParameterTypes="tfloom.interfaces.rcl_interfaces.srv",
        GetParameters="tfloom.interfaces.rcl_interfaces.srv",
        ListParameters="tfloom.interfaces.rcl_interfaces.srv",
        Node="tfloom.node.node",
        Parameter="tfloom.node.parameters.parameter",
        ParameterEvent="tfloom.interfaces.rcl_interfaces.msg",
        ParameterMsg="tfloom.node.parameters.parameter",
        QoSOverridingOptions="tfloom.node.qos.qos_overriding_options",
        QoSProfile="tfloom.node.qos.qos",
        SetParameters="tfloom.interfaces.rcl_interfaces.srv",
        SetParametersAtomically="tfloom.interfaces.rcl_interfaces.srv",
        Subscription="tfloom.node.endpoints.subscription",
        SubscriptionEventCallbacks="tfloom.node.executing.event_handler",
        parameter_dict_from_yaml_file="tfloom.node.parameters.parameter",
        qos_profile_parameter_events="tfloom.node.qos.qos",
        qos_profile_services_default="tfloom.node.qos.qos",
    )
