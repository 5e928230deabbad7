"""Overrides of QoS policies by parameters."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.qos.qos_overriding_options import InvalidQosOverridesError as InvalidQosOverridesError
from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions as QoSOverridingOptions

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.rcl_interfaces.msg import ParameterDescriptor as ParameterDescriptor
    from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult as SetParametersResult
    from tfloom.node.endpoints.publisher import Publisher as Publisher
    from tfloom.node.endpoints.subscription import Subscription as Subscription
    from tfloom.node.parameters.exceptions import ParameterAlreadyDeclaredException as ParameterAlreadyDeclaredException
    from tfloom.node.parameters.parameter import Parameter as Parameter
    from tfloom.node.qos.qos import QoSDurabilityPolicy as QoSDurabilityPolicy
    from tfloom.node.qos.qos import QoSHistoryPolicy as QoSHistoryPolicy
    from tfloom.node.qos.qos import QoSLivelinessPolicy as QoSLivelinessPolicy
    from tfloom.node.qos.qos import QoSPolicyKind as QoSPolicyKind
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
    from tfloom.node.qos.qos import QoSReliabilityPolicy as QoSReliabilityPolicy
    from tfloom.node.qos.qos_overriding_options import QoSProfileAttributes as QoSProfileAttributes
    from tfloom.node.qos.qos_overriding_options import QosCallbackResult as QosCallbackResult
    from tfloom.node.qos.qos_overriding_options import QosCallbackType as QosCallbackType
    from tfloom.node.values.duration import Duration as Duration
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Duration="tfloom.node.values.duration",
        Parameter="tfloom.node.parameters.parameter",
        ParameterAlreadyDeclaredException="tfloom.node.parameters.exceptions",
        ParameterDescriptor="tfloom.interfaces.rcl_interfaces.msg",
        Publisher="tfloom.node.endpoints.publisher",
        QoSDurabilityPolicy="tfloom.node.qos.qos",
        QoSHistoryPolicy="tfloom.node.qos.qos",
        QoSLivelinessPolicy="tfloom.node.qos.qos",
        QoSPolicyKind="tfloom.node.qos.qos",
        QoSProfile="tfloom.node.qos.qos",
        QoSProfileAttributes="tfloom.node.qos.qos_overriding_options",
        QoSReliabilityPolicy="tfloom.node.qos.qos",
        QosCallbackResult="tfloom.node.qos.qos_overriding_options",
        QosCallbackType="tfloom.node.qos.qos_overriding_options",
        SetParametersResult="tfloom.interfaces.rcl_interfaces.msg",
        Subscription="tfloom.node.endpoints.subscription",
    )
