"""The services of moveit_msgs."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import *
from tfloom_interfaces.interfaces.moveit_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from moveit_msgs.srv import _apply_planning_scene as _apply_planning_scene
    from moveit_msgs.srv import _check_if_robot_state_exists_in_warehouse as _check_if_robot_state_exists_in_warehouse
    from moveit_msgs.srv import _delete_robot_state_from_warehouse as _delete_robot_state_from_warehouse
    from moveit_msgs.srv import _get_cartesian_path as _get_cartesian_path
    from moveit_msgs.srv import _get_group_urdf as _get_group_urdf
    from moveit_msgs.srv import _get_motion_plan as _get_motion_plan
    from moveit_msgs.srv import _get_motion_sequence as _get_motion_sequence
    from moveit_msgs.srv import _get_planner_params as _get_planner_params
    from moveit_msgs.srv import _get_planning_scene as _get_planning_scene
    from moveit_msgs.srv import _get_position_fk as _get_position_fk
    from moveit_msgs.srv import _get_position_ik as _get_position_ik
    from moveit_msgs.srv import _get_robot_state_from_warehouse as _get_robot_state_from_warehouse
    from moveit_msgs.srv import _get_state_validity as _get_state_validity
    from moveit_msgs.srv import _grasp_planning as _grasp_planning
    from moveit_msgs.srv import _list_robot_states_in_warehouse as _list_robot_states_in_warehouse
    from moveit_msgs.srv import _load_geometry_from_file as _load_geometry_from_file
    from moveit_msgs.srv import _load_map as _load_map
    from moveit_msgs.srv import _query_planner_interfaces as _query_planner_interfaces
    from moveit_msgs.srv import _rename_robot_state_in_warehouse as _rename_robot_state_in_warehouse
    from moveit_msgs.srv import _save_geometry_to_file as _save_geometry_to_file
    from moveit_msgs.srv import _save_map as _save_map
    from moveit_msgs.srv import _save_robot_state_to_warehouse as _save_robot_state_to_warehouse
    from moveit_msgs.srv import _servo_command_type as _servo_command_type
    from moveit_msgs.srv import _set_planner_params as _set_planner_params
    from moveit_msgs.srv import _update_pointcloud_octomap as _update_pointcloud_octomap
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("moveit_msgs.srv")
