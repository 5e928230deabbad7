"""Demonstration nodes: topics, services, parameters, logging and events."""

from tfloom.ros_guard import claim

claim("demo_nodes_py")
