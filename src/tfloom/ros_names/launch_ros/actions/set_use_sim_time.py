"""The action that sets whether the launch's own node uses simulated time."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.frontend.expose import expose_action as expose_action
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.actions.set_use_sim_time import SetUseSimTime as SetUseSimTime
    from tfloom.launch.ros.ros_adapters import get_ros_node as get_ros_node
    from tfloom.node.parameters.parameter import Parameter as Parameter
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        Entity="tfloom.launch.frontend.entity",
        LaunchContext="tfloom.launch.launch_context",
        Parameter="tfloom.node.parameters.parameter",
        Parser="tfloom.launch.frontend.parser",
        SetUseSimTime="tfloom.launch.ros.actions.set_use_sim_time",
        expose_action="tfloom.launch.frontend.expose",
        get_ros_node="tfloom.launch.ros.ros_adapters",
    )
