"""The messages of control_msgs."""

from tfloom_interfaces.interfaces.control_msgs.msg import *
from tfloom_interfaces.interfaces.control_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from control_msgs.msg import _admittance_controller_state as _admittance_controller_state
    from control_msgs.msg import _battery_state_array as _battery_state_array
    from control_msgs.msg import _dynamic_interface_group_values as _dynamic_interface_group_values
    from control_msgs.msg import _dynamic_interface_values as _dynamic_interface_values
    from control_msgs.msg import _dynamic_joint_state as _dynamic_joint_state
    from control_msgs.msg import _float64_values as _float64_values
    from control_msgs.msg import _gripper_command as _gripper_command
    from control_msgs.msg import _interface_value as _interface_value
    from control_msgs.msg import _joint_component_tolerance as _joint_component_tolerance
    from control_msgs.msg import _joint_controller_state as _joint_controller_state
    from control_msgs.msg import _joint_jog as _joint_jog
    from control_msgs.msg import _joint_tolerance as _joint_tolerance
    from control_msgs.msg import _joint_trajectory_controller_state as _joint_trajectory_controller_state
    from control_msgs.msg import _keys as _keys
    from control_msgs.msg import _mecanum_drive_controller_state as _mecanum_drive_controller_state
    from control_msgs.msg import _motion_argument as _motion_argument
    from control_msgs.msg import _motion_primitive as _motion_primitive
    from control_msgs.msg import _motion_primitive_sequence as _motion_primitive_sequence
    from control_msgs.msg import _multi_dof_command as _multi_dof_command
    from control_msgs.msg import _multi_dof_state_stamped as _multi_dof_state_stamped
    from control_msgs.msg import _pid_state as _pid_state
    from control_msgs.msg import _single_dof_state as _single_dof_state
    from control_msgs.msg import _single_dof_state_stamped as _single_dof_state_stamped
    from control_msgs.msg import _speed_scaling_factor as _speed_scaling_factor
    from control_msgs.msg import _steering_controller_status as _steering_controller_status
    from control_msgs.msg import _vda5050_safety_state as _vda5050_safety_state
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("control_msgs.msg")
