"""ROS workspaces: packages that colcon has built, and tfloom's own programs."""
