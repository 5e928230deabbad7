"""The actions of control_msgs."""

from tfloom_interfaces.interfaces.control_msgs.action import *
from tfloom_interfaces.interfaces.control_msgs.action import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from control_msgs.action import _execute_motion_primitive_sequence as _execute_motion_primitive_sequence
    from control_msgs.action import _follow_joint_trajectory as _follow_joint_trajectory
    from control_msgs.action import _gripper_command as _gripper_command
    from control_msgs.action import _joint_trajectory as _joint_trajectory
    from control_msgs.action import _parallel_gripper_command as _parallel_gripper_command
    from control_msgs.action import _point_head as _point_head
    from control_msgs.action import _single_joint_position as _single_joint_position
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("control_msgs.action")
