"""Substitutions that join texts, and paths."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution, described
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.utilities.argument_errors import substitutions_error
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = ["PathJoinSubstitution", "PathSubstitution", "StringJoinSubstitution"]


@expose_substitution("path-join")
class PathJoinSubstitution(Substitution):
    """A path, joined of parts as `os.path.join` does. `path / part` is a path with one more part.

    Args:
        substitutions: The parts. One that is a list itself is concatenated.
    """

    def __init__(self, substitutions: Iterable[SomeSubstitutionsType]) -> None:
        super().__init__()
        parts = [substitutions] if isinstance(substitutions, (str, Path, Substitution)) else substitutions
        for part in parts:
            if (error := substitutions_error("a part of the path", part)) is not None:
                raise error
        self._parts = [normalize_to_list_of_substitutions(part) for part in parts]

    @classmethod
    def parse(
        cls, data: Sequence[SomeSubstitutionsType]
    ) -> tuple[type[PathJoinSubstitution], dict[str, Any]]:
        """Return the class and the arguments of `$(path-join part part …)`.

        Raises:
            TypeError: there is no argument.
        """
        if not data:
            raise TypeError("path-join substitution expects at least 1 argument")
        return cls, {"substitutions": data}

    @property
    def substitutions(self) -> list[Any]:
        """Parts: each a substitution, or a list of those that are concatenated."""
        return [part[0] if len(part) == 1 else part for part in self._parts]

    def __truediv__(self, additional_path: SomeSubstitutionsType) -> PathJoinSubstitution:
        """Return the path with one more part."""
        return PathJoinSubstitution([*self._parts, additional_path])

    def describe(self) -> str:
        """Return a description for people."""
        return f"PathJoinSubstitution('{', '.join(described(part) for part in self._parts)}')"

    def perform(self, context: LaunchContext) -> str:
        """Return the path."""
        return os.path.join("", *(perform_substitutions(context, part) for part in self._parts))  # noqa: PTH118  # Path drops a last "/"


class PathSubstitution(PathJoinSubstitution):
    """A path to which parts are added by `/`.

    Args:
        path: The first part.
    """

    def __init__(self, path: SomeSubstitutionsType) -> None:
        super().__init__([path])

    @classmethod
    def parse(
        cls, data: Sequence[SomeSubstitutionsType]
    ) -> tuple[type[PathJoinSubstitution], dict[str, Any]]:
        """Return the class of the joined path, and its arguments."""
        return PathJoinSubstitution.parse(data)


@expose_substitution("string-join")
class StringJoinSubstitution(Substitution):
    """Texts with a delimiter between them.

    Args:
        substitutions: The texts. One that is a list itself is concatenated.
        delimiter: What stands between two texts.
    """

    def __init__(
        self, substitutions: Iterable[SomeSubstitutionsType], delimiter: SomeSubstitutionsType = ""
    ) -> None:
        super().__init__()
        self._substitutions = [normalize_to_list_of_substitutions(part) for part in substitutions]
        self._delimiter = normalize_to_list_of_substitutions(delimiter)

    @classmethod
    def parse(
        cls, data: Sequence[SomeSubstitutionsType]
    ) -> tuple[type[StringJoinSubstitution], dict[str, Any]]:
        """Return the class and the arguments of `$(string-join delimiter text text …)`.

        Raises:
            TypeError: there are fewer than two arguments.
        """
        if len(data) < 2:
            raise TypeError(
                "string-join substitution expects at least 2 arguments: 1 delimiter + at least 1 component"
            )
        return cls, {"delimiter": data[0], "substitutions": data[1:]}

    @property
    def substitutions(self) -> list[list[Substitution]]:
        """Texts that are joined, each as substitutions."""
        return self._substitutions

    @property
    def delimiter(self) -> list[Substitution]:
        """What stands between two texts."""
        return self._delimiter

    def describe(self) -> str:
        """Return a description for people."""
        texts = ", ".join(described(part) for part in self._substitutions)
        return f"StringJoinSubstitution([{texts}], delimiter={described(self._delimiter)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the joined text."""
        texts = [perform_substitutions(context, part) for part in self._substitutions]
        return perform_substitutions(context, self._delimiter).join(texts)
