"""The actions of moveit_msgs."""

from tfloom_interfaces.interfaces.moveit_msgs.action import *
from tfloom_interfaces.interfaces.moveit_msgs.action import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from moveit_msgs.action import _execute_trajectory as _execute_trajectory
    from moveit_msgs.action import _global_planner as _global_planner
    from moveit_msgs.action import _hybrid_planner as _hybrid_planner
    from moveit_msgs.action import _local_planner as _local_planner
    from moveit_msgs.action import _move_group as _move_group
    from moveit_msgs.action import _move_group_sequence as _move_group_sequence
    from moveit_msgs.action import _pickup as _pickup
    from moveit_msgs.action import _place as _place
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("moveit_msgs.action")
