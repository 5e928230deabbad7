# PYTHON_ARGCOMPLETE_OK
"""The table of verbs, and the one way in: `main`.

Each verb is a file with `add_arguments(parser)` and `main(args) -> int`, imported when it is called.
"""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Sequence
from contextlib import suppress
from types import FrameType

from tfloom.cli.errors import CommandError, refuse_bytes
from tfloom.cli.parser import Group, build_parser

COMMANDS: dict[str, str | Group] = {
    "action": Group(
        "Ask about actions, and send goals",
        {
            "info": "Tell who serves and who calls an action",
            "list": "List the actions",
            "send_goal": "Send a goal to an action server and print what comes of it",
            "type": "Print an action's type",
        },
    ),
    "component": "Say that components need C++",
    "daemon": Group(
        "Say that there is no daemon, and that none is needed",
        {
            "start": "Say that there is none to start",
            "status": "Say that there is none to ask",
            "stop": "Say that there is none to stop",
        },
    ),
    "demo": "Show a turtle, its frames and tf2 at work",
    "doctor": "Look at what programs need to run and to find one another",
    "interface": Group(
        "Look up definitions of messages, services and actions",
        {
            "list": "List the interfaces",
            "package": "List the interfaces of one package",
            "packages": "List the packages that define interfaces",
            "proto": "Print a YAML value with an interface's fields and defaults",
            "show": "Print an interface's definition",
        },
    ),
    "lifecycle": Group(
        "Look at nodes that are configured and activated from outside, and change their state",
        {
            "get": "Print the state of a lifecycle node, or of all",
            "list": "List the transitions that a lifecycle node can be asked for",
            "nodes": "List the nodes that have a lifecycle",
            "set": "Ask a lifecycle node for a transition",
        },
    ),
    "multicast": Group(
        "Try whether multicast comes through",
        {
            "receive": "Wait for one UDP multicast datagram",
            "send": "Send one UDP multicast datagram",
        },
    ),
    "node": Group(
        "Ask about nodes",
        {
            "info": "Tell what a node publishes, subscribes to, serves and calls",
            "list": "List the nodes that are running",
        },
    ),
    "param": Group(
        "Read and change the parameters of nodes",
        {
            "delete": "Delete a parameter",
            "describe": "Tell what parameters are for and what they may hold",
            "dump": "Print all parameters of a node as YAML",
            "get": "Print a parameter's value",
            "list": "List the parameters of a node, or of all nodes",
            "load": "Set a node's parameters from a YAML file",
            "set": "Set a parameter",
        },
    ),
    "pkg": Group(
        "Ask about packages",
        {
            "create": "Make a new package for a workspace",
            "executables": "List the programs that `run` finds",
            "list": "List the packages",
            "prefix": "Print where a package is installed",
            "xml": "Print a package's package.xml, or a tag of it",
        },
    ),
    "run": "Run a program of a package",
    "service": Group(
        "Ask about services, and call them",
        {
            "call": "Call a service and print what it answers",
            "echo": "Print the requests and responses of a service that publishes its events",
            "find": "List the services of a type",
            "info": "Tell a service's type, and how many serve and call it",
            "list": "List the services",
            "type": "Print a service's type",
        },
        hidden="services",
    ),
    "topic": Group(
        "Ask about topics, listen and publish",
        {
            "bw": "Tell how many bytes a second come on a topic",
            "delay": "Tell how old messages are when they come",
            "echo": "Print the messages of a topic",
            "find": "List the topics of a type",
            "hz": "Tell how often messages come on a topic",
            "info": "Tell a topic's type, and who writes and reads it",
            "list": "List the topics",
            "pub": "Publish messages on a topic",
            "type": "Print a topic's type",
        },
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
    is_process_ours = argv is None
    try:
        try:
            return _exit_code(argv, prog)
        finally:
            if is_process_ours:
                _ignore_signals()
    except KeyboardInterrupt:
        return INTERRUPTED


def _exit_code(argv: Sequence[str] | None, prog: str) -> int:
    """Run one command line; print the error that ended it, if it is the user's."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        # A script's background jobs start so; ROS programs end on SIGINT there, too.
        signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGTERM, _terminated)
    if argv is None:  # The process is ours.
        sys.unraisablehook = _told_in_vain
    try:
        code = _run(argv, prog)
        if sys.stdout is not None:
            sys.stdout.flush()
    except BrokenPipeError:
        _drop_output()
        return PIPE_CLOSED
    except Exception as error:
        if (told := _sentence(error, prog)) is None:
            raise
        print(told, file=sys.stderr)
        if isinstance(error, OSError):
            _drop_output()
        return error.exit_code if isinstance(error, CommandError) else 1
    return code


def _ignore_signals() -> None:
    """Ignore SIGINT and SIGTERM for the rest of the process: its exit code is known.

    The interpreter's end would give them their default action, which ends the process with a code of its own.
    """
    if hasattr(signal, "setitimer"):
        signal.setitimer(signal.ITIMER_REAL, 0)  # of `_told_in_vain`
    for number in (signal.SIGINT, signal.SIGTERM):
        # One that has come and waits for its handler is handled by the first call.
        with suppress(KeyboardInterrupt, SystemExit):
            signal.signal(number, signal.SIG_IGN)
        signal.signal(number, signal.SIG_IGN)


def _sentence(error: Exception, prog: str) -> str | None:
    """Return what the user is told of an error; None of one that is a mistake of ours."""
    from tfloom.rmw.errors import WireError

    if isinstance(error, (CommandError, WireError)):
        return str(error)
    if isinstance(error, OSError):
        where = f"{error.filename}: " if error.filename else ""
        return f"{prog}: {where}{error.strerror}"
    if isinstance(error, UnicodeDecodeError):
        octet = error.object[error.start]
        return f"{prog}: octet {octet:#04x} of what was read isn't {error.encoding} text"
    if isinstance(error, RecursionError):
        return f"{prog}: a value is nested in itself, or too deeply"
    return None


def _run(argv: Sequence[str] | None, prog: str) -> int:
    parser = build_parser(prog, COMMANDS)
    if "_ARGCOMPLETE" in os.environ:
        import argcomplete

        from tfloom.cli.completion import complete_argument, fill_typed_verb

        fill_typed_verb(parser, os.environ.get("COMP_LINE", ""))
        argcomplete.autocomplete(
            parser,
            always_complete_options=False,
            default_completer=complete_argument,  # type: ignore[arg-type]  # any callable will do
        )
    args = parser.parse_args(argv)
    args.prog = prog
    if args.run_verb.__module__ != "tfloom.cli.run":
        refuse_bytes(sys.argv[1:] if argv is None else argv)
    if sys.stdout is not None:  # It may have been closed: `>&-`.
        # A letter that the terminal's encoding lacks is spelled out.
        sys.stdout.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
        if not args.use_python_default_buffering:
            sys.stdout.reconfigure(line_buffering=True)  # type: ignore[union-attr]
    return int(args.run_verb(args) or 0)


def _drop_output() -> None:
    """Write what is left in the buffer nowhere; the interpreter's flush at its end would raise again."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _told_in_vain(error: sys.UnraisableHookArgs) -> None:
    """Take a Ctrl-C that fell into a callback, which can't raise it, and let it fall again a moment later."""
    if error.exc_type is not KeyboardInterrupt:
        sys.__unraisablehook__(error)
    elif hasattr(signal, "setitimer"):
        signal.signal(signal.SIGALRM, signal.default_int_handler)
        signal.setitimer(signal.ITIMER_REAL, 0.002)


def _terminated(number: int, _: FrameType | None) -> None:
    """End on a signal as on an error, so that what is open is closed and the others on the domain are told."""
    raise SystemExit(128 + number)
