"""ROS workspaces: what colcon has built, and our own programs beside it."""
