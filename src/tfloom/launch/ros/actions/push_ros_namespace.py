"""The action that puts later nodes into a namespace."""

from __future__ import annotations

from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.ros import configurations
from tfloom.launch.ros.utilities.namespace_utils import make_namespace_absolute, prefix_namespace
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["PushROSNamespace", "PushRosNamespace"]


@expose_action("push_ros_namespace")
@expose_action("push-ros-namespace")
class PushROSNamespace(Action):
    """Puts the nodes of the rest of the scope into a namespace, under the one that they are in already.

    Args:
        namespace: The namespace, or substitutions for it; one with a slash at its start replaces the other.
        kwargs: As for Action.
    """

    def __init__(self, namespace: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._namespace = normalize_to_list_of_substitutions(namespace)

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        _, kwargs = super().parse(entity, parser)
        kwargs["namespace"] = parser.parse_substitution(entity.get_attr("namespace"))
        return cls, kwargs

    @property
    def namespace(self) -> list[Substitution]:
        """The namespace."""
        return self._namespace

    def execute(self, context: LaunchContext) -> None:
        """Set the namespace of later nodes.

        Raises:
            SubstitutionFailure: it isn't valid.
        """
        from tfloom.node.values.names import NameValidationException, validate_namespace

        pushed = perform_substitutions(context, self._namespace)
        previous = configurations.namespace(context)
        namespace = make_namespace_absolute(prefix_namespace(previous, pushed) or "/")
        try:
            validate_namespace(namespace)
        except NameValidationException as error:
            raise SubstitutionFailure(
                f"The resulting namespace is invalid: [previous_namespace='{previous}', "
                f"pushed_namespace='{pushed}']: {error}"
            ) from error
        configurations.set_namespace(context, namespace)


PushRosNamespace = PushROSNamespace
"""The former name."""
