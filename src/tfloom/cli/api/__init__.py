"""What other programs import from the packages of ROS's commands, as `ros2topic.api` and `ros2cli.node`."""
