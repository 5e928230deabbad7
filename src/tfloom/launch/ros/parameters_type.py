"""Types of parameters: as launch files give them, normalized, and evaluated."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Union

from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution
from tfloom.launch.ros.parameter_descriptions import (
    EvaluatedParameterValue,
    Parameter,
    ParameterFile,
)
from tfloom.launch.ros.parameter_descriptions import ParameterValue as ParameterValueDescription

__all__ = [
    "EvaluatedParameterValue",
    "EvaluatedParameters",
    "ParameterDescription",
    "ParameterFile",
    "ParameterName",
    "ParameterValue",
    "ParameterValueDescription",
    "Parameters",
    "ParametersDict",
    "SomeParameterFile",
    "SomeParameterName",
    "SomeParameterValue",
    "SomeParameterValue_types_tuple",
    "SomeParameters",
    "SomeParametersDict",
]

_Plain = Union[int, float, bool, Sequence[str], Sequence[int], Sequence[float], Sequence[bool], bytes]

SomeParameterFile = Union[SomeSubstitutionsType, Path, ParameterFile]
"""A file of parameters."""

SomeParameterName = Sequence[Union[Substitution, str]]

SomeParameterValue = Union[
    ParameterValueDescription, SomeSubstitutionsType, Sequence[SomeSubstitutionsType], _Plain
]
"""A value, or substitutions for it."""

SomeParameterValue_types_tuple = (
    ParameterValueDescription,
    str,
    Substitution,
    Iterable,
    Sequence,
    int,
    float,
    bool,
    bytes,
)
"""The same for `isinstance`."""

SomeParametersDict = Mapping[SomeParameterName, Any]
"""Values by name; a value may again be such a mapping."""

SomeParameters = Sequence[Union[SomeParameterFile, Parameter, SomeParametersDict]]
"""What `Node(parameters=…)` accepts."""

ParameterName = Sequence[Substitution]

ParameterValue = Union[
    Sequence[Substitution], Sequence[Sequence[Substitution]], str, _Plain, ParameterValueDescription
]
"""A value, normalized."""

ParametersDict = dict[ParameterName, ParameterValue]
"""Values by name, normalized: without mappings as values."""

ParameterDescription = Parameter

Parameters = Sequence[Union[ParameterFile, ParametersDict, ParameterDescription]]
"""What `Node(parameters=…)` accepts, normalized."""

EvaluatedParameters = Sequence[Union[Path, ParameterDescription, dict[str, EvaluatedParameterValue]]]
"""Parameters with all their substitutions performed."""
