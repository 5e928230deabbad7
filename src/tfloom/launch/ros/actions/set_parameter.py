"""The action that sets a parameter of later nodes."""

from __future__ import annotations

from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.ros import configurations
from tfloom.launch.ros.parameters_type import ParameterName, ParameterValue, SomeParameterValue
from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameter_dict
from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameter_dict
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions

__all__ = ["SetParameter"]


@expose_action("set_parameter")
class SetParameter(Action):
    """Sets a parameter of all nodes in the rest of the scope; a node's own parameters take precedence.

    Args:
        name: Name of the parameter, or substitutions for it.
        value: The value, or substitutions for it.
        kwargs: As for Action.
    """

    def __init__(self, name: SomeSubstitutionsType, value: SomeParameterValue, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        key = tuple(normalize_to_list_of_substitutions(name))
        self._parameters = normalize_parameter_dict({key: value})

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        _, kwargs = super().parse(entity, parser)
        kwargs["name"] = parser.parse_substitution(entity.get_attr("name"))
        kwargs["value"] = parser.parse_substitution(entity.get_attr("value"))
        return cls, kwargs

    @property
    def name(self) -> ParameterName:
        """Name of the parameter."""
        return next(iter(self._parameters))

    @property
    def value(self) -> ParameterValue:
        """The value."""
        return next(iter(self._parameters.values()))

    def execute(self, context: LaunchContext) -> None:
        """Set the parameter of later nodes."""
        evaluated = evaluate_parameter_dict(context, self._parameters)
        configurations.add_global_parameters(context, *evaluated.items())
