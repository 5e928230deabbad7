"""A wait for messages on topics."""

from tfloom.launch.testing.ros.wait_for_topics import WaitForTopics as WaitForTopics
from tfloom.node.executing.executors import SingleThreadedExecutor as SingleThreadedExecutor
from tfloom.node.node import Node as Node
