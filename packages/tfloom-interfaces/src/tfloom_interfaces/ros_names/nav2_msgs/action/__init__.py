"""The actions of nav2_msgs."""

from tfloom_interfaces.interfaces.nav2_msgs.action import *
from tfloom_interfaces.interfaces.nav2_msgs.action import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from nav2_msgs.action import _assisted_teleop as _assisted_teleop
    from nav2_msgs.action import _back_up as _back_up
    from nav2_msgs.action import _compute_and_track_route as _compute_and_track_route
    from nav2_msgs.action import _compute_path_through_poses as _compute_path_through_poses
    from nav2_msgs.action import _compute_path_to_pose as _compute_path_to_pose
    from nav2_msgs.action import _compute_route as _compute_route
    from nav2_msgs.action import _dock_robot as _dock_robot
    from nav2_msgs.action import _drive_on_heading as _drive_on_heading
    from nav2_msgs.action import _dummy_behavior as _dummy_behavior
    from nav2_msgs.action import _follow_gps_waypoints as _follow_gps_waypoints
    from nav2_msgs.action import _follow_object as _follow_object
    from nav2_msgs.action import _follow_path as _follow_path
    from nav2_msgs.action import _follow_waypoints as _follow_waypoints
    from nav2_msgs.action import _navigate_through_poses as _navigate_through_poses
    from nav2_msgs.action import _navigate_to_pose as _navigate_to_pose
    from nav2_msgs.action import _smooth_path as _smooth_path
    from nav2_msgs.action import _spin as _spin
    from nav2_msgs.action import _undock_robot as _undock_robot
    from nav2_msgs.action import _wait as _wait
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("nav2_msgs.action")
