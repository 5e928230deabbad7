"""The functions that other programs import from the packages of ROS's commands, as `ros2topic.api`."""
