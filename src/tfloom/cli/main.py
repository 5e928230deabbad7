"""The table of verbs, and the function `main`, which runs a command line.

Each verb is two functions, one that adds its arguments and one that runs it, whose file is imported when it is called.
"""

from __future__ import annotations

import gc
import os
import signal
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from types import FrameType
from typing import Any

from tfloom.cli.parser import Group, VerbParser, build_parser
from tfloom.cli.quiet_imports import INTERRUPTED
from tfloom.cli.shared.errors import CommandError, refuse_bytes

COMMANDS: dict[str, str | Group] = {
    "action": Group(
        "Inspect actions, and send goals",
        {
            "echo": "Print what the servers and clients of an action send one another",
            "find": "List the actions of a type",
            "info": "Print the servers and clients of an action",
            "list": "List the actions",
            "send_goal": "Send a goal to an action server and print its result",
            "type": "Print an action's type",
        },
        file="action.queries",
        own_files=("echo", "send_goal"),
    ),
    "bag": Group(
        "Various rosbag related sub-commands",
        {
            "burst": "Burst data from a bag",
            "convert": "Given an input bag, write out a new bag with different settings",
            "info": "Print information about a bag to the screen",
            "list": "Print information about available plugins to the screen",
            "play": "Play back ROS data from a bag",
            "record": "Record ROS data to a bag",
            "reindex": "Reconstruct metadata file for a bag",
        },
        file="bag.queries",
        own_files=("burst", "convert", "play", "record"),
    ),
    "component": Group(
        "Inspect the containers of components that others run, and load components into them",
        {
            "list": "List the containers and the components in them",
            "load": "Load a component into a container",
            "standalone": "Explain that a container needs C++",
            "types": "Explain that components need C++",
            "unload": "Unload components from a container",
        },
        file="component",
    ),
    "daemon": Group(
        "Explain that there is no daemon, and that none is needed",
        {
            "start": "Explain that there is no daemon to start",
            "status": "Explain that there is no daemon with a status",
            "stop": "Explain that there is no daemon to stop",
        },
        file="daemon",
    ),
    "demo": "Demonstrate turtlesim and tf2, or a robot that maps its room",
    "doctor": "Check the requirements of programs to run and to discover one another",
    "interface": Group(
        "Look up definitions of messages, services and actions",
        {
            "list": "List the interfaces",
            "package": "List the interfaces of one package",
            "packages": "List the packages that define interfaces",
            "proto": "Print a YAML value with an interface's fields and defaults",
            "show": "Print an interface's definition",
            "stubs": "Write typed modules for editors, of a workspace's packages with definitions",
        },
        aliases=("interfaces",),
        file="interface",
    ),
    "launch": "Launch a file of programs",
    "lifecycle": Group(
        "Inspect lifecycle nodes, and change their state",
        {
            "get": "Print the state of a lifecycle node, or of all",
            "list": "List the transitions that are available on a lifecycle node",
            "nodes": "List the nodes that have a lifecycle",
            "set": "Request a transition of a lifecycle node",
        },
        file="lifecycle",
    ),
    "multicast": Group(
        "Test multicast",
        {
            "receive": "Wait for one UDP multicast datagram",
            "send": "Send one UDP multicast datagram",
        },
        file="multicast",
    ),
    "node": Group(
        "Inspect nodes",
        {
            "info": "Print what a node publishes, subscribes to, serves and calls",
            "list": "List the nodes that are running",
        },
        file="node",
    ),
    "param": Group(
        "Read and change the parameters of nodes",
        {
            "delete": "Delete a parameter",
            "describe": "Print the descriptions and constraints of parameters",
            "dump": "Print all parameters of a node as YAML",
            "get": "Print the values of parameters",
            "list": "List the parameters of a node, or of all nodes",
            "load": "Set a node's parameters from a YAML file",
            "set": "Set parameters",
        },
        file="param.queries",
        own_files=("dump", "get", "load", "set"),
    ),
    "pkg": Group(
        "Inspect packages",
        {
            "create": "Create a package in a workspace",
            "executables": "List the programs that `run` finds",
            "list": "List the packages",
            "prefix": "Print where a package is installed",
            "xml": "Print a package's package.xml, or a tag of it",
        },
        file="pkg.queries",
        own_files=("create",),
    ),
    "run": "Run a program of a package",
    "security": "Explain that SROS 2 is not there, and what protects instead",
    "service": Group(
        "Inspect services, and call them",
        {
            "call": "Call a service and print its response",
            "echo": "Print the requests and responses of a service that publishes its events",
            "find": "List the services of a type",
            "info": "Print a service's type, and its numbers of servers and clients",
            "list": "List the services",
            "type": "Print a service's type",
        },
        hidden="services",
        file="service.queries",
        own_files=("call", "echo"),
    ),
    "tf": Group(
        "Check, explain and compare transforms, and keep static ones in files",
        {
            "diff": "Compare the transforms of two bags, files or graphs",
            "doctor": "Check the transforms: what is wrong, who causes it, how to mend it",
            "explain": "Explain a lookup: its chain, who publishes it, what limits it",
            "plot": "Draw position and yaw of one frame in another over time",
            "publish": "Publish the static transforms of a file",
            "save": "Write the static transforms of a live graph or a bag to a file",
            "top": "Show the transforms as they change: rates, ages, delays and publishers",
        },
    ),
    "topic": Group(
        "Inspect topics, subscribe and publish",
        {
            "bw": "Print the bandwidth of a topic, or of several",
            "delay": "Print the delay of a topic's messages",
            "echo": "Print the messages of a topic",
            "find": "List the topics of a type",
            "hz": "Print the rate of a topic's messages",
            "info": "Print a topic's type, publishers and subscriptions",
            "list": "List the topics",
            "pub": "Publish messages on a topic",
            "type": "Print a topic's type",
        },
        hidden="topics",
        file="topic.queries",
        own_files=("bw", "delay", "echo", "hz", "pub"),
    ),
    "view": "Show frames, robots and sensors in a browser",
    "zenoh": Group(
        "The router of the Zenoh wire",
        {
            "router": "Run a router, at which programs meet, until Ctrl-C",
        },
        file="zenoh",
    ),
}

PIPE_CLOSED = 141
"""Exit code when the output pipe is closed: a shell's 128 + SIGPIPE."""


def main(argv: Sequence[str] | None = None, prog: str = "tfloom") -> int:
    """Run one command line and return its exit code.

    Args:
        argv: The words after the program's name; None: those of sys.argv.
        prog: The program's name in help and errors.
    """
    is_process_ours = argv is None
    try:
        try:
            return _exit_code(argv, prog)
        finally:
            if is_process_ours:
                _ignore_signals()
                # The interpreter's exit would search all objects for cycles, which is a sixth of a short command's CPU.
                gc.freeze()
    except KeyboardInterrupt:
        return INTERRUPTED


def _exit_code(argv: Sequence[str] | None, prog: str) -> int:
    """Run one command line; print the error that ended it, if it is the user's."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        # A script's background jobs start with SIGINT ignored; ROS programs end on it there, too.
        signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGTERM, _terminated)
    if argv is None:  # This is the main program of the process.
        sys.unraisablehook = _interrupt_again
    try:
        code = _run(argv, prog)
        if sys.stdout is not None:
            sys.stdout.flush()
    except BrokenPipeError:
        from tfloom.common.terminal import drop_unwritten

        drop_unwritten(sys.stdout)
        return PIPE_CLOSED
    except Exception as error:
        if isinstance(error.__cause__, KeyboardInterrupt):
            # Until Python 3.12, one that is raised while a class is made, as by an import, is made a RuntimeError.
            raise error.__cause__ from None
        if (text := _sentence(error, prog)) is None:
            raise
        from tfloom.common.terminal import drop_unwritten, report, shown_on_terminals

        with shown_on_terminals():
            report(text)
        if isinstance(error, OSError):
            drop_unwritten(sys.stdout)
        return error.exit_code if isinstance(error, CommandError) else 1
    return code


def _ignore_signals() -> None:
    """Ignore SIGINT and SIGTERM for the rest of the process, whose exit code has been set.

    The interpreter's exit would restore their default action, which ends the process with another exit code.
    """
    if sys.platform != "win32":
        signal.setitimer(signal.ITIMER_REAL, 0)  # of `_interrupt_again`
    for number in (signal.SIGINT, signal.SIGTERM):
        # A pending signal, whose handler has not run yet, is handled by the first call.
        with suppress(KeyboardInterrupt, SystemExit):
            signal.signal(number, signal.SIG_IGN)
        signal.signal(number, signal.SIG_IGN)


def _sentence(error: Exception, prog: str) -> str | None:
    """Return the text of an error for the user; None for a bug in tfloom."""
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


def _pick(*missing: Any) -> list[str]:
    from tfloom.cli.shared.picking import values_of_missing  # which few command lines need

    return values_of_missing(*missing)


def _run(argv: Sequence[str] | None, prog: str) -> int:
    parser = build_parser(prog, COMMANDS, _add_extensions, _pick)
    if "_ARGCOMPLETE" in os.environ:
        from tfloom.cli.tab_key import complete

        complete(parser)
    args = parser.parse_args(argv)
    args.prog = prog
    if args.run_verb.__module__ != "tfloom.cli.run":
        refuse_bytes(sys.argv[1:] if argv is None else argv)
    if sys.stdout is not None:  # It may have been closed: `>&-`.
        # A character that the terminal's encoding lacks is escaped.
        sys.stdout.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
        if not args.use_python_default_buffering:
            sys.stdout.reconfigure(line_buffering=True)  # type: ignore[union-attr]
    from tfloom.common.terminal import shown_on_terminals

    with shown_on_terminals():
        return int(args.run_verb(args) or 0)


def _add_extensions(parser: VerbParser, words: Any, group: str) -> Callable[[], None]:
    from tfloom.cli.plugins.words import add_installed_words

    return add_installed_words(parser, words, group)


def _interrupt_again(error: sys.UnraisableHookArgs) -> None:
    """Interrupt the main thread again after a Ctrl-C inside a callback, because a callback can't raise it."""
    if error.exc_type is not KeyboardInterrupt:
        sys.__unraisablehook__(error)
    elif sys.platform != "win32":
        signal.signal(signal.SIGALRM, signal.default_int_handler)
        signal.setitimer(signal.ITIMER_REAL, 0.002)


def _terminated(number: int, _: FrameType | None) -> None:
    """Raise SystemExit on a signal, so that all is closed and the other participants are notified."""
    raise SystemExit(128 + number)
