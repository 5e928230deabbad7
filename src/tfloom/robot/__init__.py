"""Robots: their description in URDF, their joints' states, and the frames of their links.

- xml_elements, urdf, urdf_values, description, joint_tree, mimicry: URDF, read;  urdf_faults: what is wrong with it
- visuals: what is seen of the links
- model: forward kinematics on arrays
- robot_transforms, robot_state_publisher: frames of the links
- joint_state_publisher: states of the joints
- xacro_program: xacro
"""
