"""Installed packages that extend the command: metadata with entry points, and modules with their classes."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import pytest
from tests.conftest import run_to_end
from transcript import Output, exit_code_of

__all__ = ["MODULE", "install", "run_cli", "run_here"]

MODULE = '''
from ros2cli.command import CommandExtension, add_subparsers_on_demand
from ros2cli.node.strategy import NodeStrategy, add_arguments
from ros2topic.api import TopicNameCompleter, get_topic_names_and_types
from ros2topic.verb import VerbExtension


class FirstVerb(VerbExtension):
    """Print the first topics.

    More about it.
    """

    def add_arguments(self, parser, cli_name):
        add_arguments(parser)
        parser.add_argument("-n", type=int, default=1, help=f"how many, in {cli_name}")
        parser.add_argument("--fail", action="store_true")

    def main(self, *, args):
        if args.fail:
            raise RuntimeError("no topics today")
        with NodeStrategy(args) as node:
            names = get_topic_names_and_types(node=node)
        for name, types in names[: args.n]:
            print(name, types)


class TreeCommand(CommandExtension):
    """Show trees."""

    def add_arguments(self, parser, cli_name):
        self._subparser = parser
        add_subparsers_on_demand(parser, cli_name, "_verb", "ros2tree.verb", required=False)

    def main(self, *, parser, args):
        if not hasattr(args, "_verb"):
            self._subparser.print_help()
            return 0
        return args._verb.main(args=args)


class GrowVerb(VerbExtension):
    """Let a tree grow."""

    def add_arguments(self, parser, cli_name):
        parser.add_argument("height", type=int)

    def main(self, *, args):
        print(self.NAME, "to", args.height)
        return 3


class TooNewVerb(VerbExtension):
    """Not for this one."""

    def __init__(self):
        super().__init__()
        from ros2cli.plugin_system import PLUGIN_SYSTEM_VERSION, satisfies_version

        satisfies_version(PLUGIN_SYSTEM_VERSION, "^0.2")
'''
"""A module `my_extensions`."""


def run_cli(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Run `tfloom` with a folder on the path, which has extensions."""
    return run_to_end([sys.executable, "-m", "tfloom", *words], env={**os.environ, "PYTHONPATH": str(folder)})


class Run(NamedTuple):
    """A command's exit code, and what it printed."""

    returncode: int
    stdout: str
    stderr: str


def run_here(folder: Path, *words: str) -> Run:
    """Run the command in this process, under ros2's name, with a folder on the path, which has extensions."""
    out, err = Output(), Output()
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(folder)
        sys.modules.pop("my_extensions", None)  # that of another test
        code = exit_code_of(words, out, err)
    return Run(code, out.text, err.text)


def install(folder: Path, entry_points: Mapping[str, Mapping[str, str]], module: str = MODULE) -> Path:
    """Write `my_extensions` into a folder, with its metadata as pip writes it; return the folder.

    Args:
        folder: To be added to the path.
        entry_points: For each group, what each name stands for.
        module: The source of the module.
    """
    (folder / "my_extensions.py").write_text(module, "utf-8")
    metadata = folder / "my_extensions-1.0.dist-info"
    metadata.mkdir()
    (metadata / "METADATA").write_text("Metadata-Version: 2.1\nName: my-extensions\nVersion: 1.0\n", "utf-8")
    groups = (
        f"[{group}]\n" + "".join(f"{name} = {value}\n" for name, value in values.items())
        for group, values in entry_points.items()
    )
    (metadata / "entry_points.txt").write_text("\n".join(groups), "utf-8")
    return folder
