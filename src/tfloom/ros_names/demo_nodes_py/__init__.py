"""The smallest nodes that talk, listen, serve and ask."""

from tfloom.ros_guard import claim

claim("demo_nodes_py")
