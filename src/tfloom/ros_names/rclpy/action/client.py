"""Action clients."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.action.client import ActionClient as ActionClient
from tfloom.node.action.client import ClientGoalHandle as ClientGoalHandle

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.action_msgs.msg import GoalStatus as GoalStatus
    from tfloom.interfaces.action_msgs.srv import CancelGoal as CancelGoal
    from tfloom.interfaces.unique_identifier_msgs.msg import UUID as UUID
    from tfloom.node.executing.executors import await_or_execute as await_or_execute
    from tfloom.node.executing.task import Future as Future
    from tfloom.node.executing.waitable import NumberOfEntities as NumberOfEntities
    from tfloom.node.executing.waitable import Waitable as Waitable
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
    from tfloom.node.qos.qos import qos_profile_action_status_default as qos_profile_action_status_default
    from tfloom.node.qos.qos import qos_profile_services_default as qos_profile_services_default
    from tfloom.node.values.type_support import check_for_type_support as check_for_type_support
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CancelGoal="tfloom.interfaces.action_msgs.srv",
        Future="tfloom.node.executing.task",
        GoalStatus="tfloom.interfaces.action_msgs.msg",
        NumberOfEntities="tfloom.node.executing.waitable",
        QoSProfile="tfloom.node.qos.qos",
        UUID="tfloom.interfaces.unique_identifier_msgs.msg",
        Waitable="tfloom.node.executing.waitable",
        await_or_execute="tfloom.node.executing.executors",
        check_for_type_support="tfloom.node.values.type_support",
        qos_profile_action_status_default="tfloom.node.qos.qos",
        qos_profile_services_default="tfloom.node.qos.qos",
    )
