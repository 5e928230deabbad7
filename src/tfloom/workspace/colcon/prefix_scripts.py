"""The scripts that source a workspace, where the path of the environment's Python has a space."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from colcon_core.shell import ShellExtensionPoint

from tfloom.common.files import write_file

__all__ = ["QuotedPython"]

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
