"""The action that sets whether the launch's own node uses simulated time."""

from __future__ import annotations

from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.ros.ros_adapters import get_ros_node

__all__ = ["SetUseSimTime"]


@expose_action("set_use_sim_time")
class SetUseSimTime(Action):
    """Sets whether the launch's node, by which ROSTimer measures, uses the time of the topic /clock.

    Other nodes get it by SetParameter("use_sim_time", …).

    Args:
        value: Whether it does.
        kwargs: As for Action.
    """

    def __init__(self, value: bool, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._value = value

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        _, kwargs = super().parse(entity, parser)
        kwargs["value"] = entity.get_attr("value", data_type=bool, can_be_str=False)
        return cls, kwargs

    @property
    def value(self) -> bool:
        """Whether the node uses simulated time."""
        return self._value

    def execute(self, context: LaunchContext) -> None:
        """Set the parameter of the launch's node."""
        from tfloom.node.parameters.parameter import Parameter

        get_ros_node(context).set_parameters([Parameter(name="use_sim_time", value=self._value)])
