"""Action servers."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.action.server import ActionServer as ActionServer
from tfloom.node.action.server import CancelResponse as CancelResponse
from tfloom.node.action.server import GoalResponse as GoalResponse
from tfloom.node.action.server import ServerGoalHandle as ServerGoalHandle
from tfloom.node.action.server import default_cancel_callback as default_cancel_callback
from tfloom.node.action.server import default_goal_callback as default_goal_callback
from tfloom.node.action.server import default_handle_accepted_callback as default_handle_accepted_callback

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.action_msgs.msg import GoalInfo as GoalInfo
    from tfloom.interfaces.action_msgs.msg import GoalStatus as GoalStatus
    from tfloom.node.action.goal_states import GoalEvent as GoalEvent
    from tfloom.node.executing.executors import await_or_execute as await_or_execute
    from tfloom.node.executing.task import Future as Future
    from tfloom.node.executing.waitable import NumberOfEntities as NumberOfEntities
    from tfloom.node.executing.waitable import Waitable as Waitable
    from tfloom.node.qos.qos import QoSProfile as QoSProfile
    from tfloom.node.qos.qos import qos_profile_action_status_default as qos_profile_action_status_default
    from tfloom.node.qos.qos import qos_profile_services_default as qos_profile_services_default
    from tfloom.node.values.exceptions import RCLError as RCLError
    from tfloom.node.values.type_support import check_for_type_support as check_for_type_support
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Future="tfloom.node.executing.task",
        GoalEvent="tfloom.node.action.goal_states",
        GoalInfo="tfloom.interfaces.action_msgs.msg",
        GoalStatus="tfloom.interfaces.action_msgs.msg",
        NumberOfEntities="tfloom.node.executing.waitable",
        QoSProfile="tfloom.node.qos.qos",
        RCLError="tfloom.node.values.exceptions",
        Waitable="tfloom.node.executing.waitable",
        await_or_execute="tfloom.node.executing.executors",
        check_for_type_support="tfloom.node.values.type_support",
        qos_profile_action_status_default="tfloom.node.qos.qos",
        qos_profile_services_default="tfloom.node.qos.qos",
    )
