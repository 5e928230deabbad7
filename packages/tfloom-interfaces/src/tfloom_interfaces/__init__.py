"""Interface packages beyond ROS 2's common ones, for tfloom: generated classes, their definitions and façades."""
