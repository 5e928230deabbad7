"""The services of control_msgs."""

from tfloom_interfaces.interfaces.control_msgs.srv import *
from tfloom_interfaces.interfaces.control_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from control_msgs.srv import _query_calibration_state as _query_calibration_state
    from control_msgs.srv import _query_trajectory_state as _query_trajectory_state
    from control_msgs.srv import _set_odometry as _set_odometry
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("control_msgs.srv")
