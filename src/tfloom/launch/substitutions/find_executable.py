"""The path of an executable, and programs that a launch runs by name."""

from __future__ import annotations

import sys
from pathlib import Path

from tfloom.launch.core.base_classes import (
    ParsedSubstitution,
    SomeSubstitutionsType,
    Substitution,
    SubstitutionFailure,
    described,
)
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.missing import marked_as_missing
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = ["FindExecutable", "command_of", "find_program"]


@expose_substitution("find-exec")
class FindExecutable(ParsedSubstitution):
    """The path of an executable that PATH leads to, or that the environment has whose Python launches.

    Args:
        name: Name of the executable.
    """

    _arguments = ("name",)
    _fault = "find-exec substitution expects 1 argument"
    _error = AttributeError

    def __init__(self, *, name: SomeSubstitutionsType) -> None:
        super().__init__()
        self._name = normalize_to_list_of_substitutions(name)

    @property
    def name(self) -> list[Substitution]:
        """Name of the executable."""
        return self._name

    def describe(self) -> str:
        """Return a description for people."""
        return f"FindExec({described(self._name)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the path.

        Raises:
            SubstitutionFailure: no folder of PATH has the executable, nor has the environment that launches.
        """
        name = perform_substitutions(context, self._name)
        path = find_program(context, name)
        if path is None:
            raise marked_as_missing(SubstitutionFailure(f"executable '{name}' not found on the PATH"))
        return path


def find_program(context: LaunchContext, name: str) -> str | None:
    """Return the path of an executable, or None.

    The folders of PATH come first, then that of the programs of this Python, because an environment that is not
    activated is not on PATH.
    """
    import shutil

    program = shutil.which(name, path=context.environment.get("PATH"))
    return program or shutil.which(name, path=str(_scripts_folder()))


def command_of(context: LaunchContext, name: str) -> list[str]:
    """Return the beginning of the command line that runs a program: its path, its name if it isn't found.

    `ros2` and `xacro` are run by tfloom itself, unless PATH leads to others than those of this Python.
    """
    here = [sys.executable, "-m", "tfloom"]
    own = {"ros2": here, "xacro": [*here, "run", "xacro", "xacro"]}.get(name)
    path = find_program(context, name)
    if own is not None and (path is None or Path(path).parent == _scripts_folder()):
        return own
    return [path or name]


def _scripts_folder() -> Path:
    import sysconfig

    return Path(sysconfig.get_path("scripts"))
