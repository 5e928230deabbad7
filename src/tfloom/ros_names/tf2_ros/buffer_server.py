"""Serve lookups of other programs from one buffer, by an action."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.buffer_server import BufferServer as BufferServer
