"""Action clients."""

from typing import TYPE_CHECKING

from tfloom.interfaces.action_msgs.msg import GoalStatus as GoalStatus
from tfloom.interfaces.action_msgs.srv import CancelGoal as CancelGoal
from tfloom.interfaces.unique_identifier_msgs.msg import UUID as UUID
from tfloom.node.action.client import *
from tfloom.node.executing.executors import await_or_execute as await_or_execute
from tfloom.node.executing.task import Future as Future
from tfloom.node.qos.qos import QoSProfile as QoSProfile
from tfloom.node.qos.qos import qos_profile_action_status_default as qos_profile_action_status_default
from tfloom.node.qos.qos import qos_profile_services_default as qos_profile_services_default

if TYPE_CHECKING:
    from tfloom.node.executing.waitable import NumberOfEntities as NumberOfEntities
    from tfloom.node.executing.waitable import Waitable as Waitable
    from tfloom.node.values.type_support import check_for_type_support as check_for_type_support
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        NumberOfEntities="tfloom.node.executing.waitable",
        Waitable="tfloom.node.executing.waitable",
        check_for_type_support="tfloom.node.values.type_support",
    )
