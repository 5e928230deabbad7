"""The node of a launch, by which its actions call services, subscribe and time; it is created on first use."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.ros.ros_adapters import ROSAdapter as ROSAdapter
    from tfloom.launch.ros.ros_adapters import get_ros_adapter as get_ros_adapter
    from tfloom.launch.ros.ros_adapters import get_ros_node as get_ros_node
    from tfloom.node.executing.executors import SingleThreadedExecutor as SingleThreadedExecutor
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ROSAdapter="tfloom.launch.ros.ros_adapters",
        SingleThreadedExecutor="tfloom.node.executing.executors",
        get_ros_adapter="tfloom.launch.ros.ros_adapters",
        get_ros_node="tfloom.launch.ros.ros_adapters",
    )
