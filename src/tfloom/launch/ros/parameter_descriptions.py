"""Parameters of nodes as launch files describe them: a value with its type, a name with a value, a file."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any, List, Union, cast

from tfloom.common.seconds import plain_value
from tfloom.launch.core.base_classes import (
    SomeSubstitutionsType,
    SomeSubstitutionsType_types_tuple,
    Substitution,
)
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.private_names import HasPrivateNames
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.utilities.argument_types import ensure_argument_type
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions
from tfloom.launch.utilities.type_utils import (
    AllowedTypesType,
    FilePath,
    SomeValueType,
    data_type_error,
    is_normalized_substitution,
    normalize_typed_substitution,
    perform_typed_substitution,
)

__all__ = ["EvaluatedParameterValue", "Parameter", "ParameterFile", "ParameterValue", "warn_of_unmatched"]

EvaluatedParameterValue = Union[
    str, int, float, bool, Sequence[str], Sequence[int], Sequence[float], Sequence[bool], bytes
]
"""A value of a parameter."""


class ParameterValue(HasPrivateNames):
    """A parameter's value, with the type that it will have.

    Args:
        value: The value, or substitutions for it.
        value_type: int, float, bool, str, or a list of one of them, `list[int]`; None: the type that YAML gives the
            text of the substitutions, by the rules of parameter files.
    """

    def __init__(self, value: SomeValueType, *, value_type: AllowedTypesType | None = None) -> None:
        value = plain_value(value)
        if value_type is not None and (error := data_type_error(value_type)) is not None:
            raise error
        if isinstance(value, (list, tuple)) and {type(item) for item in value} == {int, float}:
            value = [float(item) for item in cast("Sequence[float]", value)]
        self._value = normalize_typed_substitution(value, value_type)
        self._value_type = value_type
        self._evaluated: Any = None

    @property
    def value(self) -> Any:
        """The value, after `evaluate` with its substitutions performed."""
        return self._value if self._evaluated is None else self._evaluated

    @property
    def value_type(self) -> AllowedTypesType | None:
        """The type that it will have."""
        return self._value_type

    def __str__(self) -> str:
        return f"{_place(self)}(value={self.value}, value_type={self.value_type})"

    def evaluate(self, context: LaunchContext) -> EvaluatedParameterValue:
        """Return the value, with its substitutions performed.

        Raises:
            ValueError: their text is not a value of the type.
        """
        if self._value_type is None:
            self._evaluated = _perform_untyped(context, self._value)
        elif self._value_type in (list[float], List[float]) and is_normalized_substitution(self._value):
            self._evaluated = _perform_floats(context, self._value)
        else:
            self._evaluated = perform_typed_substitution(context, self._value, self._value_type)
        return cast("EvaluatedParameterValue", self._evaluated)


def _perform_floats(context: LaunchContext, value: list[Substitution]) -> Any:
    """Return a text's list of floats, of which an item may be a whole number."""
    from tfloom.launch.ros.utilities.parameter_text import untyped_value

    try:
        items = untyped_value(perform_substitutions(context, value))
    except ValueError:
        items = None
    if isinstance(items, list) and {type(item) for item in items} <= {int, float}:
        return [float(item) for item in items]
    return perform_typed_substitution(context, value, list[float])  # raises its error


def _perform_untyped(context: LaunchContext, value: Any) -> Any:
    from tfloom.launch.ros.utilities.parameter_text import untyped_items, untyped_value
    from tfloom.node.parameters.parameter_file import checked_value

    if is_normalized_substitution(value):
        text = perform_substitutions(context, value)
        performed = untyped_value(text)
        if isinstance(performed, dict):
            raise ValueError(f"a parameter's value can't be a mapping, as {text!r} is")
    elif isinstance(value, list):
        # A text that stands there as one is a text by its type.
        texts = [perform_substitutions(context, item) for item in value if is_normalized_substitution(item)]
        values = iter(untyped_items(texts))
        performed = [next(values) if is_normalized_substitution(item) else item for item in value]
    else:
        return value
    return checked_value("value", performed)


class Parameter(HasPrivateNames):
    """A parameter's name and value.

    Args:
        name: The name, or substitutions for it.
        value, value_type: See ParameterValue.
    """

    def __init__(
        self,
        name: SomeSubstitutionsType,
        value: SomeValueType,
        *,
        value_type: AllowedTypesType | None = None,
    ) -> None:
        ensure_argument_type(name, SomeSubstitutionsType_types_tuple, "name")
        self._name = normalize_to_list_of_substitutions(name)
        self._parameter_value = ParameterValue(value, value_type=value_type)
        self._evaluated_name: str | None = None

    @property
    def name(self) -> list[Substitution] | str:
        """The name, after `evaluate` with its substitutions performed."""
        return self._name if self._evaluated_name is None else self._evaluated_name

    @property
    def value(self) -> Any:
        """The value, after `evaluate` with its substitutions performed."""
        return self._parameter_value.value

    @property
    def value_type(self) -> AllowedTypesType | None:
        """The type that the value will have."""
        return self._parameter_value.value_type

    def __str__(self) -> str:
        return f"{_place(self)}(name={self.name}, value={self.value}, value_type={self.value_type})"

    def evaluate(self, context: LaunchContext) -> tuple[str, EvaluatedParameterValue]:
        """Return the name and the value, with their substitutions performed.

        Raises:
            ValueError: the text of the value is none of the type.
        """
        self._evaluated_name = perform_substitutions(context, self._name)
        return self._evaluated_name, self._parameter_value.evaluate(context)


class ParameterFile(HasPrivateNames):
    """A file of parameters.

    Args:
        param_file: Its path, or substitutions for it.
        allow_substs: Whether substitutions in the file, as `$(env HOME)`, are performed.
    """

    def __init__(
        self,
        param_file: FilePath | SomeSubstitutionsType,
        *,
        allow_substs: bool | SomeSubstitutionsType = False,
    ) -> None:
        ensure_argument_type(
            param_file,
            (*SomeSubstitutionsType_types_tuple, os.PathLike, bytes),
            "param_file",
            "ParameterFile",
        )
        ensure_argument_type(
            allow_substs, (bool, *SomeSubstitutionsType_types_tuple), "allow_subst", "ParameterFile"
        )
        self._param_file = _substitutions_of_path(param_file)
        self._allow_substs = normalize_typed_substitution(allow_substs, bool)
        self._evaluated_allow_substs: bool | None = None
        self._evaluated_param_file: Path | None = None
        self._created_file: Path | None = None

    @property
    def param_file(self) -> FilePath | list[Substitution]:
        """The path, after `evaluate` with its substitutions performed."""
        return self._param_file if self._evaluated_param_file is None else self._evaluated_param_file

    @property
    def allow_substs(self) -> Any:
        """Whether substitutions in the file are performed."""
        return self._allow_substs if self._evaluated_allow_substs is None else self._evaluated_allow_substs

    def __str__(self) -> str:
        return f"{_place(self)}(param_file={self.param_file!r}, allow_substs={self.allow_substs})"

    def evaluate(self, context: LaunchContext) -> Path:
        """Return the path of the file, or of a temporary one with its substitutions performed.

        Raises:
            OSError: the file can't be read.
            SubstitutionFailure: the text with its substitutions performed is not YAML.
        """
        if self._evaluated_param_file is not None:
            return self._evaluated_param_file
        path = Path(perform_substitutions(context, self._param_file))
        allowed = perform_typed_substitution(context, self._allow_substs, bool)
        if allowed:
            path = self._created_file = _file_with_substitutions(context, path)
        self._evaluated_allow_substs = allowed
        self._evaluated_param_file = path
        return path

    def cleanup(self) -> None:
        """Remove the temporary file, if there is one."""
        if self._created_file is not None:
            self._created_file.unlink(missing_ok=True)
            self._created_file = self._evaluated_param_file = None


def _place(described: object) -> str:
    return f"launch_ros.parameter_descriptions.{type(described).__name__}"


def _substitutions_of_path(path: FilePath | SomeSubstitutionsType) -> list[Substitution]:
    if isinstance(path, (bytes, os.PathLike)):
        return normalize_to_list_of_substitutions(os.fsdecode(path))
    return normalize_to_list_of_substitutions(path)


def _file_with_substitutions(context: LaunchContext, path: Path) -> Path:
    from tfloom.common.yaml import YamlError, compose_all
    from tfloom.launch.core.base_classes import SubstitutionFailure
    from tfloom.launch.frontend.parse_substitution import parse_substitution
    from tfloom.launch.ros.temporary_files import write_temporary_file

    try:
        text = perform_substitutions(context, parse_substitution(path.read_text("utf-8")))
    except SubstitutionFailure as error:
        raise SubstitutionFailure(f"{path}: {error}") from error
    try:
        compose_all(text)
    except YamlError as error:
        raise SubstitutionFailure(
            f"The substituted parameter file is not a valid yaml file: {path}: {error}"
        ) from error
    return write_temporary_file(context, text, prefix="launch_params_", suffix=".yaml")


def warn_of_unmatched(path: Path, node_name: str) -> None:
    """Warn if a parameter file has values, and none for a node of this full name.

    A file that can't be read is left to the node, which reports it.
    """
    from tfloom.node.parameters.parameter_file import read_parameter_file

    try:
        rules = read_parameter_file(path)
    except (OSError, ValueError):
        return
    if rules and not any(rule.is_for(node_name) for rule in rules):
        nodes = ", ".join(dict.fromkeys(rule.node for rule in rules))
        get_logger("launch_ros.actions.node").warning(
            f"the parameter file {path} has no values for the node {node_name}: it has those of {nodes}"
        )
