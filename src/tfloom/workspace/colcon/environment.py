"""What sourcing a package's scripts sets beside its paths."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from colcon_core.environment import EnvironmentExtensionPoint
from colcon_core.shell import ShellExtensionPoint

from tfloom.common.files import write_file
from tfloom.ros_imports.ros_distro import ROS_ENVIRONMENT

__all__ = ["QuotedPython"]


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


_UNQUOTED = "$($_colcon_python_executable "
_QUOTED = '$("$_colcon_python_executable" '


class QuotedPython(ShellExtensionPoint):
    """Quotes Python's path in `local_setup.sh` and `local_setup.bash`.

    colcon's own scripts run it unquoted, so that in an environment under `/home/me/my robots` they end with
    "/home/me/my: No such file or directory". This is not another shell: it runs after those that write the scripts.
    """

    PRIORITY = 10  # below those of all shells

    def create_prefix_script(self, prefix_path: Path, merge_install: bool) -> list[Path]:
        """Correct the scripts of a workspace; return none, because none is added."""
        for path in (prefix_path / "local_setup.sh", prefix_path / "local_setup.bash"):
            text = path.read_text("utf-8") if path.is_file() else ""
            if _UNQUOTED in text:
                write_file(path, text.replace(_UNQUOTED, _QUOTED))
        return []

    def create_package_script(self, prefix_path: Path, pkg_name: str, hooks: Any) -> list[Path]:
        """Add no script of a package."""
        return []
