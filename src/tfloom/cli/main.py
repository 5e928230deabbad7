"""The table of verbs, and the one way in: `main`.

Each verb is a file with `add_arguments(parser)` and `main(args) -> int`, imported when it is called.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from tfloom.cli.errors import CommandError
from tfloom.cli.parser import Group, build_parser

COMMANDS: dict[str, str | Group] = {
    "node": Group("Ask about nodes", {"list": "List the nodes that are running"}),
    "run": "Run a program of a package",
    "topic": Group(
        "Ask about topics, listen and publish",
        {"list": "List the topics"},
        hidden="topics",
    ),
}

INTERRUPTED = 2
"""Exit code after Ctrl-C, as ros2's."""
PIPE_CLOSED = 141
"""Exit code when nobody reads the output any more: a shell's 128 + SIGPIPE."""


def main(argv: Sequence[str] | None = None, prog: str = "tfloom") -> int:
    """Run one command line and return its exit code.

    Args:
        argv: The words after the program's name; None takes sys.argv's.
        prog: The program's name in help and errors.
    """
    parser = build_parser(prog, COMMANDS)
    if "_ARGCOMPLETE" in os.environ:
        import argcomplete

        argcomplete.autocomplete(parser)
    args = parser.parse_args(argv)
    args.prog = prog
    if not args.use_python_default_buffering:
        sys.stdout.reconfigure(line_buffering=True)  # type: ignore[union-attr]
    try:
        code = int(args.run_verb(args) or 0)
        sys.stdout.flush()
    except CommandError as error:
        print(error, file=sys.stderr)
        return error.exit_code
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:
        # What is left in the buffer would raise again when the interpreter flushes it at its end.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return PIPE_CLOSED
    except Exception as error:
        from tfloom.rmw.errors import WireError

        if not isinstance(error, WireError):
            raise
        print(error, file=sys.stderr)
        return 1
    return code
