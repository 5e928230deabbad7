"""The action that remaps a name for later nodes."""

from __future__ import annotations

from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.ros import configurations
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["SetRemap"]


@expose_action("set_remap")
class SetRemap(Action):
    """Remaps a name for all nodes in the rest of the scope.

    Args:
        src: The name, or substitutions for it.
        dst: Its replacement, or substitutions for it.
        kwargs: As for Action.
    """

    def __init__(self, src: SomeSubstitutionsType, dst: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._src = normalize_to_list_of_substitutions(src)
        self._dst = normalize_to_list_of_substitutions(dst)

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        _, kwargs = super().parse(entity, parser)
        kwargs["src"] = parser.parse_substitution(entity.get_attr("from"))
        kwargs["dst"] = parser.parse_substitution(entity.get_attr("to"))
        return cls, kwargs

    @property
    def src(self) -> list[Substitution]:
        """The name."""
        return self._src

    @property
    def dst(self) -> list[Substitution]:
        """Its replacement."""
        return self._dst

    def execute(self, context: LaunchContext) -> None:
        """Remap the name for later nodes."""
        configurations.add_remapping(
            context, perform_substitutions(context, self._src), perform_substitutions(context, self._dst)
        )
