"""The action that gives later nodes the parameters of a file."""

from __future__ import annotations

from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.ros import configurations
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["SetParametersFromFile"]


@expose_action("set_parameters_from_file")
class SetParametersFromFile(Action):
    """Gives all nodes in the rest of the scope the parameters of a file; a node's own parameters take precedence.

    Args:
        filename: Path of the file, or substitutions for it.
        kwargs: As for Action.
    """

    def __init__(self, filename: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._filename = normalize_to_list_of_substitutions(filename)

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        _, kwargs = super().parse(entity, parser)
        kwargs["filename"] = parser.parse_substitution(entity.get_attr("filename"))
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        """Give later nodes the file."""
        configurations.add_global_parameters(context, perform_substitutions(context, self._filename))
