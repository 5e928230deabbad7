"""A node that a thread spins."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.ros.message_pump import MessagePump as MessagePump
