"""The action that starts a node."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any, ClassVar

from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.core.base_classes import LaunchDescriptionEntity, SomeSubstitutionsType
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.ros import configurations
from tfloom.launch.ros.parameter_descriptions import Parameter
from tfloom.launch.ros.parameters_type import SomeParameters
from tfloom.launch.ros.substitutions import ExecutableInPackage
from tfloom.launch.ros.utilities.names import (
    SomeRemapRules,
    add_node_name,
    get_node_name_count,
    make_namespace_absolute,
    normalize_remap_rules,
    prefix_namespace,
    remappings_error,
)
from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameters, parameters_error
from tfloom.launch.substitutions.variables import LocalSubstitution
from tfloom.launch.utilities.argument_errors import substitutions_error, unknown_argument_error, words_error
from tfloom.launch.utilities.substitutions import (
    normalize_to_list_of_substitutions,
    perform_some_substitutions,
    perform_substitutions,
)

__all__ = ["Node"]


@expose_action("node")
class Node(ExecuteProcess):
    """Starts a program of a package as a node.

    The command line is the program, `arguments`, `--ros-args`, `ros_arguments`, and then what the other arguments stand
    for: `-r __node:=…`, `-r __ns:=…`, `-p …` and `--params-file …`, `-r from:=to`.

    Args:
        executable: The program; without a package, a path or a program on PATH.
        package: Its package.
        name: Name of the node; None: the program's own choice.
        namespace: Namespace of the node, under the one of PushROSNamespace.
        exec_name: Name of the process; None: the program's.
        parameters: Files, mappings of names to values, and Parameter objects. Later ones take precedence.
        remappings: Pairs of a name and its replacement.
        ros_arguments: ROS arguments, without `--ros-args`.
        arguments: Other arguments of the program.
        kwargs: As for ExecuteProcess.
    """

    _other_names: ClassVar = {
        "expanded_node_name": "_expanded_name",
        "expanded_node_namespace": "_expanded_namespace",
        "node_executable": "_executable",
        "node_name": "_given_name",
        "node_namespace": "_given_namespace",
    }
    UNSPECIFIED_NODE_NAME = "<node_name_unspecified>"
    UNSPECIFIED_NODE_NAMESPACE = "<node_namespace_unspecified>"

    def __init__(
        self,
        *,
        executable: SomeSubstitutionsType,
        package: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        exec_name: SomeSubstitutionsType | None = None,
        parameters: SomeParameters | None = None,
        remappings: SomeRemapRules | None = None,
        ros_arguments: Iterable[SomeSubstitutionsType] | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
        **kwargs: Any,
    ) -> None:
        named = {"executable": executable, "package": package, "name": name, "namespace": namespace}
        for argument, value in named.items():
            if (value is not None or argument == "executable") and (
                error := substitutions_error(argument, value)
            ) is not None:
                raise error
        error = unknown_argument_error(Node, kwargs) or words_error("arguments", arguments or ())
        error = (
            error or words_error("ros_arguments", ros_arguments or ()) or remappings_error(remappings or ())
        )
        if (error := error or parameters_error(parameters)) is not None:
            raise error
        program = executable if package is None else ExecutableInPackage(executable, package)
        cmd: list[SomeSubstitutionsType] = [program, *(arguments or ()), "--ros-args", *(ros_arguments or ())]
        # The name stands in a local variable, which `execute` sets: extensions may change it until then.
        if name is not None:
            cmd += ["-r", LocalSubstitution("ros_specific_arguments['name']", description="node name")]
        super().__init__(cmd=cmd, name=exec_name, **kwargs)
        self._package = package
        self._arguments = arguments
        self._executable = executable
        self._given_name = name
        self._given_namespace = namespace
        self._parameters = None if parameters is None else normalize_parameters(parameters)
        self._remappings = [] if remappings is None else list(normalize_remap_rules(remappings))
        self._expanded_name = self.UNSPECIFIED_NODE_NAME
        self._expanded_namespace = self.UNSPECIFIED_NODE_NAMESPACE
        self._final_node_name: str | None = None
        # What gives each parameter, and whether that is a file; tests of launch files read it by this name.
        self.__expanded_parameter_arguments: list[tuple[str | Parameter, bool]] = []
        self._expanded_remappings: list[tuple[str, str]] | None = None

    @staticmethod
    def parse_nested_parameters(params: list[Entity], parser: ParsesActions) -> list[Any]:
        """Return what the tags `param` stand for, as the argument `parameters` takes it."""
        from tfloom.launch.ros.utilities.parse_node_tags import parse_nested_parameters

        return parse_nested_parameters(params, parser)

    @classmethod
    def parse(
        cls, entity: Entity, parser: ParsesActions, ignore: list[str] | None = None
    ) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        from tfloom.launch.ros.utilities.parse_node_tags import parse_parameters, parse_remappings

        _, kwargs = super().parse(entity, parser, ignore=["cmd", *(ignore or ())])
        for attribute, argument in (("args", "arguments"), ("ros_args", "ros_arguments")):
            if (text := entity.get_attr(attribute, optional=True)) is not None:
                kwargs[argument] = cls._parse_cmdline(text, parser)
        kwargs["executable"] = parser.parse_substitution(entity.get_attr("exec"))
        optional = {"pkg": "package", "name": "name", "namespace": "namespace", "exec_name": "exec_name"}
        for attribute, argument in optional.items():
            kwargs.pop(argument, None)  # `name` is the process's for ExecuteProcess, and the node's here
            if (text := entity.get_attr(attribute, optional=True)) is not None:
                kwargs[argument] = parser.parse_substitution(text)
        if (remappings := parse_remappings(entity, parser)) is not None:
            kwargs["remappings"] = remappings
        if (parameters := parse_parameters(entity, parser)) is not None:
            kwargs["parameters"] = parameters
        return cls, kwargs

    @property
    def node_package(self) -> SomeSubstitutionsType | None:
        """Package of the program."""
        return self._package

    @property
    def node_executable(self) -> SomeSubstitutionsType:
        """Name of the program, or its path if there is no package."""
        return self._executable

    @property
    def node_name(self) -> str:
        """Full name of the node, with UNSPECIFIED_… for what isn't given; after the action was executed.

        Raises:
            RuntimeError: it was not.
        """
        if self._final_node_name is None:
            raise RuntimeError("cannot access 'node_name' before executing action")
        return self._final_node_name

    @property
    def expanded_node_namespace(self) -> str:
        """Namespace of the node; UNSPECIFIED_NODE_NAMESPACE without one, and before the action is executed."""
        return self._expanded_namespace

    @property
    def expanded_remapping_rules(self) -> list[tuple[str, str]] | None:
        """Remappings of the node, those of SetRemap first; None without any, and before the action is executed."""
        return self._expanded_remappings or None

    def is_node_name_fully_specified(self) -> bool:
        """Return whether both the name and the namespace are given."""
        unspecified = (self.UNSPECIFIED_NODE_NAME, self.UNSPECIFIED_NODE_NAMESPACE)
        return not any(placeholder in self.node_name for placeholder in unspecified)

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the process.

        Raises:
            NameValidationException: the node's name or namespace is not valid.
            PackageNotFoundError, SubstitutionFailure: there is no such package or program.
            TypeError: a parameter's value has a type that parameters don't have.
        """
        # The command line gets its last words before `super().execute`, which performs its substitutions, those of
        # `ros_specific_arguments` among them.
        self._perform_substitutions(context)
        arguments: dict[str, Any] = {}
        if self._given_name is not None:
            arguments["name"] = f"__node:={self._expanded_name}"
        if self._expanded_namespace != self.UNSPECIFIED_NODE_NAMESPACE:
            arguments["ns"] = f"__ns:={self._expanded_namespace}"
        for extension in _extensions():
            words, arguments = extension.prepare_for_execute(context, arguments, self)
            self._add_words(*words)
        context.extend_locals({"ros_specific_arguments": arguments})
        entities = super().execute(context)
        self._count_name(context)
        return entities

    def _perform_substitutions(self, context: LaunchContext) -> None:
        """Perform the substitutions of names, parameters and remappings once, and put them on the command line."""
        # Once, because it appends to the command line; a LifecycleNode has called it before `Node.execute` does.
        if self._final_node_name is not None:
            return
        try:
            self._perform_names(context)
        except Exception:
            get_logger("launch_ros.actions.node").error(
                f"Error while expanding or validating node name or namespace for 'package={self._package}, "
                f"executable={self._executable}, name={self._given_name}, namespace={self._given_namespace}':"
            )
            raise
        self._perform_parameters(context)
        self._perform_remappings(context)

    def _perform_names(self, context: LaunchContext) -> None:
        from tfloom.node.values.names import validate_namespace, validate_node_name

        if self._given_name is not None:
            name = perform_some_substitutions(context, self._given_name)
            validate_node_name(name)
            self._expanded_name = name
        namespace = None
        if self._given_namespace is not None:
            namespace = perform_some_substitutions(context, self._given_namespace)
        # Without a namespace here or around the node, no `__ns` is passed on, so that the program's own choice holds.
        joined_namespace = prefix_namespace(configurations.namespace(context), namespace)
        if joined_namespace is not None:
            self._expanded_namespace = make_namespace_absolute(joined_namespace)
            validate_namespace(self._expanded_namespace)
            self._add_words("-r", LocalSubstitution("ros_specific_arguments['ns']"))
        self._final_node_name = prefix_namespace(self._expanded_namespace, self._expanded_name)

    def _perform_parameters(self, context: LaunchContext) -> None:
        from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameters
        from tfloom.launch.ros.utilities.parameter_text import parameter_rule

        # The order is the precedence: the program takes the last value that the command line has for a parameter. So
        # those of SetParameter and SetParametersFromFile come first, and the node's own override them.
        files: list[Path] = []
        for global_parameter in configurations.global_parameters(context):
            if isinstance(global_parameter, tuple):
                self._add_rule(parameter_rule(*global_parameter))
            else:
                self._add_file(Path(global_parameter).absolute(), files)
        for parameters in evaluate_parameters(context, self._parameters or ()):
            if isinstance(parameters, Path):
                self._add_file(parameters, files)
            elif isinstance(parameters, Parameter):
                self._add_rule(parameter_rule(*parameters.evaluate(context)), parameters)
            else:
                written = self._write_file(context, parameters)
                self.__expanded_parameter_arguments.append((written, True))
                self._add_words("--params-file", written)
        if files and self._given_name is not None:
            from tfloom.launch.ros.parameter_descriptions import warn_of_unmatched

            for path in files:
                warn_of_unmatched(path, self._assumed_name())

    def _add_rule(self, rule: str, parameter: Parameter | None = None) -> None:
        self.__expanded_parameter_arguments.append((rule if parameter is None else parameter, False))
        self._add_words("-p", rule)

    def _add_file(self, path: Path, files: list[Path]) -> None:
        if path.is_file():
            files.append(path)
            self.__expanded_parameter_arguments.append((str(path), True))
            self._add_words("--params-file", str(path))
        else:
            get_logger("launch_ros.actions.node").warning(f"Parameter file path is not a file: {path}")

    def _write_file(self, context: LaunchContext, parameters: Any) -> str:
        from tfloom.launch.ros.temporary_files import write_temporary_file
        from tfloom.launch.ros.utilities.parameter_text import parameter_file_text

        # Without a full name, the file is for any node: only this program gets it.
        node = self.node_name if self.is_node_name_fully_specified() else "/**"
        text = parameter_file_text(node, parameters)
        return str(write_temporary_file(context, text, prefix="launch_params_"))

    def _perform_remappings(self, context: LaunchContext) -> None:
        self._expanded_remappings = configurations.remappings(context) + [
            (perform_substitutions(context, name), perform_substitutions(context, replacement))
            for name, replacement in self._remappings
        ]
        for name, replacement in self._expanded_remappings:
            self._add_words("-r", f"{name}:={replacement}")

    def _add_words(self, *words: SomeSubstitutionsType) -> None:
        self.cmd.extend(normalize_to_list_of_substitutions(word) for word in words)

    def _assumed_name(self) -> str:
        """Return the full name: without a namespace, the node is in the root."""
        return self.node_name.replace(self.UNSPECIFIED_NODE_NAMESPACE, "")

    def _count_name(self, context: LaunchContext) -> None:
        """Warn of a second node of the same name."""
        if self._given_name is None:
            return
        name = self._assumed_name()
        add_node_name(context, name)
        if (count := get_node_name_count(context, name)) > 1:
            get_logger(str(self.name)).warning(
                f"there are now at least {count} nodes with the name {name} created within this launch context"
            )


def _extensions() -> list[Any]:
    from tfloom.launch.ros.actions.node_extensions import get_extensions

    return list(get_extensions(get_logger("launch_ros.actions.node")).values())
