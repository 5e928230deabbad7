"""What sourcing a package's scripts sets beside its paths."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from colcon_core.environment import EnvironmentExtensionPoint

from tfloom.common.files import write_file
from tfloom.ros_imports.environment import ROS_ENVIRONMENT

_LINES = {
    "dsv": "set-if-unset;{name};{value}",
    "sh": ': "${{{name}={value}}}"; export {name}',
    "ps1": 'if (-not (Test-Path Env:{name})) {{ $Env:{name} = "{value}" }}',
    "bat": 'if not defined {name} set "{name}={value}"',
}
"""How each kind of script sets a variable that is not set. colcon itself has only lines that set it in any case."""


class RosEnvironment(EnvironmentExtensionPoint):
    """Set ROS_DISTRO, ROS_VERSION and ROS_PYTHON_VERSION, as a sourced ROS does."""

    def create_environment_hooks(self, prefix_path: Path, pkg_name: str) -> list[Path]:
        """Write a script for each kind of shell, and return their paths."""
        folder = prefix_path / "share" / pkg_name / "hook"
        return [
            _write(folder / f"ros_environment.{kind}", line, ROS_ENVIRONMENT) for kind, line in _LINES.items()
        ]


def _write(path: Path, line: str, variables: Mapping[str, str]) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    write_file(path, "".join(f"{line.format(name=name, value=value)}\n" for name, value in variables.items()))
    return path
