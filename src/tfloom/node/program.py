"""Start and end of tfloom's own programs, which end without a traceback when they are stopped."""

from __future__ import annotations

import sys
from collections.abc import Callable

from tfloom.common.terminal import shown_on_terminals
from tfloom.node.client_library import init
from tfloom.node.context.utilities import get_default_context, remove_ros_args, try_shutdown
from tfloom.node.values.exceptions import ExternalShutdownException

__all__ = ["expect_no_arguments", "run_program"]


def run_program(args: list[str] | None, body: Callable[[], int | None], *, if_stopped: int = 0) -> int:
    """Initialise the default context, run `body()`, and shut down.

    Ctrl-C, SIGTERM and a shutdown end the body at any point, without a traceback.

    Args:
        args: Command line, with its ROS arguments; None: `sys.argv`.
        body: The program's work; it may return an exit code.
        if_stopped: Exit code of a program that was stopped.

    Returns:
        The exit code.

    Raises:
        Exception: raised by the body, unless it was stopped.
    """
    context = get_default_context()
    try:
        with shown_on_terminals():
            init(args=args)
            return body() or 0
    except (KeyboardInterrupt, ExternalShutdownException):
        return if_stopped
    except Exception as error:
        # A signal arrived between two calls, of which the second needs the context.
        if not context.is_caused_by_signal(error):
            raise
        return if_stopped
    finally:
        try_shutdown()


def expect_no_arguments(program: str, description: str, args: list[str] | None = None) -> None:
    """Exit with a usage text if a command line has other than ROS arguments, and with the help text on `--help`.

    Args:
        program: The program's name.
        description: What it does, for the help text.
        args: Command line; None: `sys.argv`.

    Raises:
        RCLInvalidROSArgsError: a ROS argument is malformed.
    """
    words = remove_ros_args(sys.argv[1:] if args is None else args)
    if words:
        import argparse

        argparse.ArgumentParser(prog=program, description=description).parse_args(words)
