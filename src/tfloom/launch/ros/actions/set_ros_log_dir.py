"""The action that sets the folder of later nodes' logs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["SetROSLogDir"]


@expose_action("set_ros_log_dir")
class SetROSLogDir(Action):
    """Sets the folder of the logs of processes that are started later, by the variable ROS_LOG_DIR.

    Args:
        new_log_dir: The folder, or substitutions for it; a relative path is one within the present folder.
        kwargs: As for Action.
    """

    def __init__(self, new_log_dir: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._log_dir = normalize_to_list_of_substitutions(new_log_dir)

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        _, kwargs = super().parse(entity, parser)
        kwargs["new_log_dir"] = parser.parse_substitution(entity.get_attr("new_log_dir"))
        return cls, kwargs

    @property
    def log_dir(self) -> list[Substitution]:
        """The folder."""
        return self._log_dir

    def execute(self, context: LaunchContext) -> None:
        """Set the folder of later processes."""
        from tfloom.node.log.logging import get_logging_directory

        present = context.environment.get("ROS_LOG_DIR") or str(get_logging_directory())
        folder = Path(present, perform_substitutions(context, self._log_dir))
        context.environment["ROS_LOG_DIR"] = str(folder)
