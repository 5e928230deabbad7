"""Quality of service: profiles, policies and their compatibility."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.qos.qos import DurabilityPolicy as DurabilityPolicy
from tfloom.node.qos.qos import HistoryPolicy as HistoryPolicy
from tfloom.node.qos.qos import InvalidQoSProfileException as InvalidQoSProfileException
from tfloom.node.qos.qos import LivelinessPolicy as LivelinessPolicy
from tfloom.node.qos.qos import QoSDurabilityPolicy as QoSDurabilityPolicy
from tfloom.node.qos.qos import QoSHistoryPolicy as QoSHistoryPolicy
from tfloom.node.qos.qos import QoSLivelinessPolicy as QoSLivelinessPolicy
from tfloom.node.qos.qos import QoSPolicyEnum as QoSPolicyEnum
from tfloom.node.qos.qos import QoSPolicyKind as QoSPolicyKind
from tfloom.node.qos.qos import QoSPresetProfiles as QoSPresetProfiles
from tfloom.node.qos.qos import QoSProfile as QoSProfile
from tfloom.node.qos.qos import QoSReliabilityPolicy as QoSReliabilityPolicy
from tfloom.node.qos.qos import ReliabilityPolicy as ReliabilityPolicy
from tfloom.node.qos.qos import qos_check_compatible as qos_check_compatible
from tfloom.node.qos.qos import qos_policy_name_from_kind as qos_policy_name_from_kind
from tfloom.node.qos.qos import qos_profile_action_status_default as qos_profile_action_status_default
from tfloom.node.qos.qos import qos_profile_best_available as qos_profile_best_available
from tfloom.node.qos.qos import qos_profile_default as qos_profile_default
from tfloom.node.qos.qos import qos_profile_parameter_events as qos_profile_parameter_events
from tfloom.node.qos.qos import qos_profile_parameters as qos_profile_parameters
from tfloom.node.qos.qos import qos_profile_rosout_default as qos_profile_rosout_default
from tfloom.node.qos.qos import qos_profile_sensor_data as qos_profile_sensor_data
from tfloom.node.qos.qos import qos_profile_services_default as qos_profile_services_default
from tfloom.node.qos.qos import qos_profile_system_default as qos_profile_system_default
from tfloom.node.qos.qos import qos_profile_unknown as qos_profile_unknown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.qos.qos import DeadlineBestAvailable as DeadlineBestAvailable
    from tfloom.node.qos.qos import LivelinessLeaseDurationeBestAvailable as LivelinessLeaseDurationeBestAvailable
    from tfloom.node.qos.qos import QoSCompatibility as QoSCompatibility
    from tfloom.node.values.duration import Duration as Duration
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        DeadlineBestAvailable="tfloom.node.qos.qos",
        Duration="tfloom.node.values.duration",
        LivelinessLeaseDurationeBestAvailable="tfloom.node.qos.qos",
        QoSCompatibility="tfloom.node.qos.qos",
    )
