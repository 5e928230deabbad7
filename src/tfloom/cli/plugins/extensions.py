"""The base classes of extensions: commands, as `ros2 topic`, and verbs, as `ros2 topic echo`."""

from __future__ import annotations

import argparse
from typing import Any

from tfloom.cli.plugins.plugin_system import (
    PLUGIN_SYSTEM_VERSION,
    instantiate_extensions,
    satisfies_version,
)

__all__ = ["CommandExtension", "VerbExtension", "get_command_extensions", "get_verb_extensions"]


class _Extension:
    """What a command and a verb have in common."""

    NAME: str | None = None
    """The name of the entry point, which is set when the extension is created."""
    EXTENSION_POINT_VERSION = "0.1"

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(PLUGIN_SYSTEM_VERSION, "^0.1")


class CommandExtension(_Extension):
    """A command, whose entry point is in the group `ros2cli.command`.

    A derived class defines `main`, and `add_arguments` if it takes any. Its docstring's first line is its help.
    """

    def add_arguments(
        self, parser: argparse.ArgumentParser, cli_name: str, *, argv: list[str] | None = None
    ) -> None:
        """Add the command's arguments to its parser."""

    def main(self, *, parser: argparse.ArgumentParser, args: argparse.Namespace) -> int | str | None:
        """Run the command; return its exit code, None for 0, or the text of an error."""
        raise NotImplementedError


class VerbExtension(_Extension):
    """A verb, whose entry point is in its command's group, as `ros2topic.verb`.

    A derived class defines `main`, and `add_arguments` if it takes any. Its docstring's first line is its help.
    """

    def add_arguments(self, parser: argparse.ArgumentParser, cli_name: str) -> None:
        """Add the verb's arguments to its parser."""

    def main(self, *, args: argparse.Namespace) -> int | str | None:
        """Run the verb; return its exit code, None for 0, or the text of an error."""
        raise NotImplementedError


def get_command_extensions(group_name: str, *, exclude_names: Any = None) -> dict[str, Any]:
    """Return the commands of a group by name, in order of their names."""
    return dict(sorted(instantiate_extensions(group_name, exclude_names=exclude_names).items()))


def get_verb_extensions(name: str) -> dict[str, Any]:
    """Return the verbs of a group by name, in order of their names."""
    return dict(sorted(instantiate_extensions(name).items()))
