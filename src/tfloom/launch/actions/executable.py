"""Command lines with their folder and environment."""

from __future__ import annotations

import itertools
import re
import shlex
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.private_names import HasPrivateNames
from tfloom.launch.substitutions.variables import LaunchConfiguration
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from tfloom.launch.entities.action import Action

__all__ = ["Executable"]

Substitutions = list[Substitution]
Variables = list[tuple[Substitutions, Substitutions]]

_process_numbers = itertools.count(1)
"""Numbers of processes, which are unique among all launches of a program: the names of processes have them."""


class Executable(HasPrivateNames):
    """A program to start.

    Args:
        cmd: The words of the command line, the program first.
        prefix: Words in front of it, as a shell would split them (`gdb -ex run --args`). None: those of the launch
            configuration `launch-prefix`, for programs whose file name `launch-prefix-filter` matches.
        name: The process's name, without its number; None: the program's file name.
        cwd: The folder to start in; None: the launch's.
        env: All of its environment variables; None: those of the launch.
        additional_env: Variables in addition to those.
        arguments: More words at the end of the command line.
    """

    def __init__(
        self,
        *,
        cmd: Iterable[SomeSubstitutionsType],
        prefix: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        cwd: SomeSubstitutionsType | None = None,
        env: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        additional_env: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
    ) -> None:
        self._cmd = [normalize_to_list_of_substitutions(word) for word in cmd]
        self._cmd += [normalize_to_list_of_substitutions(word) for word in arguments or ()]
        self._arguments = arguments
        self._is_filtered = prefix is None
        self._prefix = normalize_to_list_of_substitutions(
            LaunchConfiguration("launch-prefix", default="") if prefix is None else prefix
        )
        self._prefix_filter = normalize_to_list_of_substitutions(
            LaunchConfiguration("launch-prefix-filter", default="")
        )
        self._name = None if name is None else normalize_to_list_of_substitutions(name)
        self._cwd = None if cwd is None else normalize_to_list_of_substitutions(cwd)
        self._env = None if env is None else _variables(env)
        self._additional_env = None if additional_env is None else _variables(additional_env)
        self._final_name: str | None = None
        self._final_cmd: list[str] | None = None
        self._final_cwd: str | None = None
        self._final_env: dict[str, str] | None = None

    @property
    def name(self) -> Substitutions | None:
        """Name of the process, without its number."""
        return self._name

    @property
    def prefix(self) -> Substitutions:
        """Words in front of the command line."""
        return self._prefix

    @property
    def cmd(self) -> list[Substitutions]:
        """Words of the command line."""
        return self._cmd

    @property
    def cwd(self) -> Substitutions | None:
        """Folder to start in; None: the launch's."""
        return self._cwd

    @property
    def env(self) -> Variables | None:
        """All environment variables; None: those of the launch."""
        return self._env

    @property
    def additional_env(self) -> Variables | None:
        """Environment variables in addition to those."""
        return self._additional_env

    @property
    def arguments(self) -> Iterable[SomeSubstitutionsType] | None:
        """Words at the end of the command line."""
        return self._arguments

    @property
    def final_name(self) -> str | None:
        """Name of the process, with its number; None before `prepare`."""
        return self._final_name

    @property
    def final_cmd(self) -> list[str] | None:
        """Words of the command line, with the prefix; None before `prepare`."""
        return self._final_cmd

    @property
    def final_cwd(self) -> str | None:
        """Folder to start in; None before `prepare`, and for the launch's."""
        return self._final_cwd

    @property
    def final_env(self) -> dict[str, str] | None:
        """All environment variables of the process; None before `prepare`."""
        return self._final_env

    def prepare(self, context: LaunchContext, action: Action) -> None:
        """Perform all substitutions, for the action that will start the process."""
        cmd = [perform_substitutions(context, word) for word in self._cmd]
        if not cmd or not cmd[0]:
            raise ValueError("a command line is empty: its first word is the program to start")
        name = Path(cmd[0]).name if self._name is None else perform_substitutions(context, self._name)
        self._final_name = f"{name}-{next(_process_numbers)}"
        prefix = shlex.split(perform_substitutions(context, self._prefix))
        if prefix and self._is_filtered:
            pattern = perform_substitutions(context, self._prefix_filter)
            if pattern and not re.match(pattern, Path(cmd[0]).name):
                prefix = []
        self._final_cmd = prefix + cmd
        self._final_cwd = None if self._cwd is None else perform_substitutions(context, self._cwd)
        variables = dict(context.environment) if self._env is None else _perform_variables(context, self._env)
        variables.update(_perform_variables(context, self._additional_env or []))
        self._final_env = variables


def _variables(variables: Mapping[SomeSubstitutionsType, SomeSubstitutionsType]) -> Variables:
    return [
        (normalize_to_list_of_substitutions(name), normalize_to_list_of_substitutions(value))
        for name, value in variables.items()
    ]


def _perform_variables(context: LaunchContext, variables: Variables) -> dict[str, str]:
    return {
        perform_substitutions(context, name): perform_substitutions(context, value)
        for name, value in variables
    }
