"""`ros2cli.cli`: the command line as a function, for programs that run it or their own command."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from tfloom.cli.plugins.entry_points import get_first_line_doc

if TYPE_CHECKING:
    from tfloom.cli.plugins.extensions import CommandExtension

__all__ = ["main"]


def main(
    *,
    script_name: str = "ros2",
    argv: Sequence[str] | None = None,
    description: str | None = None,
    extension: CommandExtension | None = None,
) -> int | str | None:
    """Run one command line; return its exit code, None for 0, or the text of an error.

    Args:
        script_name: The program's name in help and errors.
        argv: The words after it; None: those of sys.argv.
        description: What the help of `extension` says; None: the first line of its docstring.
        extension: The command that takes the words; None: all of `ros2`.
    """
    if extension is None:
        from tfloom.cli.main import main as run_command_line

        return run_command_line(argv, script_name)
    from tfloom.cli.parser import VerbParser

    text = get_first_line_doc(extension) if description is None else description
    parser = VerbParser(prog=script_name, description=text)
    extension.add_arguments(parser, script_name)
    try:
        return extension.main(parser=parser, args=parser.parse_args(argv))
    except RuntimeError as error:  # as in the reference, where extensions raise it for the user
        return str(error)
