"""The messages of moveit_msgs."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import *
from tfloom_interfaces.interfaces.moveit_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from moveit_msgs.msg import _allowed_collision_entry as _allowed_collision_entry
    from moveit_msgs.msg import _allowed_collision_matrix as _allowed_collision_matrix
    from moveit_msgs.msg import _attached_collision_object as _attached_collision_object
    from moveit_msgs.msg import _bounding_volume as _bounding_volume
    from moveit_msgs.msg import _cartesian_point as _cartesian_point
    from moveit_msgs.msg import _cartesian_trajectory as _cartesian_trajectory
    from moveit_msgs.msg import _cartesian_trajectory_point as _cartesian_trajectory_point
    from moveit_msgs.msg import _collision_object as _collision_object
    from moveit_msgs.msg import _constraint_eval_result as _constraint_eval_result
    from moveit_msgs.msg import _constraints as _constraints
    from moveit_msgs.msg import _contact_information as _contact_information
    from moveit_msgs.msg import _cost_source as _cost_source
    from moveit_msgs.msg import _display_robot_state as _display_robot_state
    from moveit_msgs.msg import _display_trajectory as _display_trajectory
    from moveit_msgs.msg import _generic_trajectory as _generic_trajectory
    from moveit_msgs.msg import _grasp as _grasp
    from moveit_msgs.msg import _gripper_translation as _gripper_translation
    from moveit_msgs.msg import _joint_constraint as _joint_constraint
    from moveit_msgs.msg import _joint_limits as _joint_limits
    from moveit_msgs.msg import _kinematic_solver_info as _kinematic_solver_info
    from moveit_msgs.msg import _link_padding as _link_padding
    from moveit_msgs.msg import _link_scale as _link_scale
    from moveit_msgs.msg import _motion_plan_detailed_response as _motion_plan_detailed_response
    from moveit_msgs.msg import _motion_plan_request as _motion_plan_request
    from moveit_msgs.msg import _motion_plan_response as _motion_plan_response
    from moveit_msgs.msg import _motion_sequence_item as _motion_sequence_item
    from moveit_msgs.msg import _motion_sequence_request as _motion_sequence_request
    from moveit_msgs.msg import _motion_sequence_response as _motion_sequence_response
    from moveit_msgs.msg import _move_it_error_codes as _move_it_error_codes
    from moveit_msgs.msg import _object_color as _object_color
    from moveit_msgs.msg import _orientation_constraint as _orientation_constraint
    from moveit_msgs.msg import _oriented_bounding_box as _oriented_bounding_box
    from moveit_msgs.msg import _pipeline_state as _pipeline_state
    from moveit_msgs.msg import _place_location as _place_location
    from moveit_msgs.msg import _planner_interface_description as _planner_interface_description
    from moveit_msgs.msg import _planner_params as _planner_params
    from moveit_msgs.msg import _planning_options as _planning_options
    from moveit_msgs.msg import _planning_scene as _planning_scene
    from moveit_msgs.msg import _planning_scene_components as _planning_scene_components
    from moveit_msgs.msg import _planning_scene_world as _planning_scene_world
    from moveit_msgs.msg import _position_constraint as _position_constraint
    from moveit_msgs.msg import _position_ik_request as _position_ik_request
    from moveit_msgs.msg import _robot_state as _robot_state
    from moveit_msgs.msg import _robot_trajectory as _robot_trajectory
    from moveit_msgs.msg import _servo_status as _servo_status
    from moveit_msgs.msg import _trajectory_constraints as _trajectory_constraints
    from moveit_msgs.msg import _visibility_constraint as _visibility_constraint
    from moveit_msgs.msg import _workspace_parameters as _workspace_parameters
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("moveit_msgs.msg")
