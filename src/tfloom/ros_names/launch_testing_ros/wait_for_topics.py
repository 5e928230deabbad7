"""A wait for messages on topics."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.ros.wait_for_topics import WaitForTopics as WaitForTopics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.executing.executors import SingleThreadedExecutor as SingleThreadedExecutor
    from tfloom.node.node import Node as Node
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Node="tfloom.node.node",
        SingleThreadedExecutor="tfloom.node.executing.executors",
    )
