"""Actions that set what holds for the nodes after them: parameters, remappings, namespace, folder of logs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tfloom.launch.actions.texts import ActionOfTexts
from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution, SubstitutionFailure
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.ros import configurations
from tfloom.launch.ros.parameters_type import ParameterName, ParameterValue, SomeParameterValue
from tfloom.launch.ros.ros_adapters import get_ros_node
from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameter_dict
from tfloom.launch.ros.utilities.names import make_namespace_absolute, prefix_namespace
from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameter_dict
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = [
    "PushROSNamespace",
    "PushRosNamespace",
    "SetParameter",
    "SetParametersFromFile",
    "SetROSLogDir",
    "SetRemap",
    "SetUseSimTime",
]


@expose_action("set_parameter")
class SetParameter(ActionOfTexts):
    """Sets a parameter of all nodes in the rest of the scope; a node's own parameters take precedence.

    Args:
        name: Name of the parameter, or substitutions for it.
        value: The value, or substitutions for it.
        kwargs: As for Action.
    """

    _attributes = (("name", "name"), ("value", "value"))

    def __init__(self, name: SomeSubstitutionsType, value: SomeParameterValue, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        key = tuple(normalize_to_list_of_substitutions(name))
        self._parameters = normalize_parameter_dict({key: value})

    @property
    def name(self) -> ParameterName:
        """Name of the parameter."""
        return next(iter(self._parameters))

    @property
    def value(self) -> ParameterValue:
        """Value of the parameter, normalized."""
        return next(iter(self._parameters.values()))

    def execute(self, context: LaunchContext) -> None:
        """Set the parameter of later nodes."""
        evaluated = evaluate_parameter_dict(context, self._parameters)
        configurations.add_global_parameters(context, *evaluated.items())


@expose_action("set_parameters_from_file")
class SetParametersFromFile(ActionOfTexts):
    """Gives all nodes in the rest of the scope the parameters of a file; a node's own parameters take precedence.

    Args:
        filename: Path of the file, or substitutions for it.
        kwargs: As for Action.
    """

    _attributes = (("filename", "filename"),)

    def __init__(self, filename: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._filename = normalize_to_list_of_substitutions(filename)

    def execute(self, context: LaunchContext) -> None:
        """Give later nodes the file."""
        configurations.add_global_parameters(context, perform_substitutions(context, self._filename))


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


@expose_action("set_remap")
class SetRemap(ActionOfTexts):
    """Remaps a name for all nodes in the rest of the scope.

    Args:
        src: The name, or substitutions for it.
        dst: Its replacement, or substitutions for it.
        kwargs: As for Action.
    """

    _attributes = (("src", "from"), ("dst", "to"))

    def __init__(self, src: SomeSubstitutionsType, dst: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._src = normalize_to_list_of_substitutions(src)
        self._dst = normalize_to_list_of_substitutions(dst)

    @property
    def src(self) -> list[Substitution]:
        """Name that is replaced."""
        return self._src

    @property
    def dst(self) -> list[Substitution]:
        """Name that replaces it."""
        return self._dst

    def execute(self, context: LaunchContext) -> None:
        """Remap the name for later nodes."""
        configurations.add_remapping(
            context, perform_substitutions(context, self._src), perform_substitutions(context, self._dst)
        )


@expose_action("set_ros_log_dir")
class SetROSLogDir(ActionOfTexts):
    """Sets the folder of the logs of processes that are started later, by the variable ROS_LOG_DIR.

    Args:
        new_log_dir: The folder, or substitutions for it; a relative path is one within that of ROS_LOG_DIR.
        kwargs: As for Action.
    """

    _attributes = (("new_log_dir", "new_log_dir"),)

    def __init__(self, new_log_dir: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._log_dir = normalize_to_list_of_substitutions(new_log_dir)

    @property
    def log_dir(self) -> list[Substitution]:
        """Folder of the logs of later processes."""
        return self._log_dir

    def execute(self, context: LaunchContext) -> None:
        """Set the folder of later processes."""
        present = context.environment.get("ROS_LOG_DIR", "")
        folder = Path(present, perform_substitutions(context, self._log_dir))
        context.environment["ROS_LOG_DIR"] = str(folder)


@expose_action("push_ros_namespace")
@expose_action("push-ros-namespace")
class PushROSNamespace(ActionOfTexts):
    """Puts the nodes of the rest of the scope into a namespace, under the one that they are in already.

    Args:
        namespace: The namespace, or substitutions for it; one with a slash at its start replaces the other.
        kwargs: As for Action.
    """

    _attributes = (("namespace", "namespace"),)

    def __init__(self, namespace: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._namespace = normalize_to_list_of_substitutions(namespace)

    @property
    def namespace(self) -> list[Substitution]:
        """Namespace that is pushed; it is relative to the one around it unless it begins with a slash."""
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
"""Former name of PushROSNamespace, which launch files still use."""
