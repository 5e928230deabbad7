"""The scripts of `ament_environment_hooks`, which set variables when the workspace is sourced."""

from __future__ import annotations

from typing import NamedTuple

__all__ = ["KINDS", "WRAPPED_KINDS", "EnvironmentHook", "wrapper"]

KINDS = ("dsv", "sh", "bash", "zsh", "ps1", "bat")
"""What the names of such scripts end in: lines for all shells, or a script for one."""
WRAPPED_KINDS = ("sh", "bash", "zsh")
"""Those that may call ament's functions, which the scripts of colcon have under other names."""

_WRAPPER = """\
AMENT_CURRENT_PREFIX="$COLCON_CURRENT_PREFIX"
ament_prepend_unique_value() {{
  eval "_ament_values=\\"\\${{$1-}}\\""
  case ":$_ament_values:" in
    *":$2:"*) ;;
    *) export "$1=$2${{_ament_values:+:$_ament_values}}" ;;
  esac
  unset _ament_values
}}
ament_append_unique_value() {{
  eval "_ament_values=\\"\\${{$1-}}\\""
  case ":$_ament_values:" in
    *":$2:"*) ;;
    *) export "$1=${{_ament_values:+$_ament_values:}}$2" ;;
  esac
  unset _ament_values
}}
. "$AMENT_CURRENT_PREFIX/{path}"
unset AMENT_CURRENT_PREFIX
unset -f ament_prepend_unique_value ament_append_unique_value
"""


class EnvironmentHook(NamedTuple):
    """One script, with its variables replaced."""

    name: str
    """`models.dsv`"""
    content: bytes
    line: int

    @property
    def kind(self) -> str:
        """One of KINDS."""
        return self.name.rpartition(".")[2]


def wrapper(path: str) -> str:
    """Return a script that gives another one what ament gives it: the prefix, and the functions for lists.

    Args:
        path: The other script's, below the prefix.
    """
    return _WRAPPER.format(path=path)
