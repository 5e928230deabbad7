"""A node that a thread spins."""

from tfloom.launch.testing.ros.message_pump import MessagePump as MessagePump
