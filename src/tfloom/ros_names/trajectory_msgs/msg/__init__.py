"""The messages of trajectory_msgs."""

from tfloom.interfaces.trajectory_msgs.msg import *
from tfloom.interfaces.trajectory_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from trajectory_msgs.msg import _joint_trajectory as _joint_trajectory
    from trajectory_msgs.msg import _joint_trajectory_point as _joint_trajectory_point
    from trajectory_msgs.msg import _multi_dof_joint_trajectory as _multi_dof_joint_trajectory
    from trajectory_msgs.msg import _multi_dof_joint_trajectory_point as _multi_dof_joint_trajectory_point
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("trajectory_msgs.msg")
