"""Demonstrate turtlesim and tf2, or a robot that maps its room.

The programs are processes on this machine; those with turtles are threads of this process if there is no DDS.
"""

from __future__ import annotations

import argparse
import os
import sys

from tfloom.cli.shared.numbers import seconds

INTRODUCTION = """\
One turtle draws a figure, with a laser mounted on it; another follows it by their transforms on tf.
Below is the output of `tf2_echo world laser`: the pose of the laser in the world.
{end}"""
ROBOT = """\
A simulated robot drives round its room. Its odometry drifts, and a node corrects it by the scans of a laser, which it
draws into a map. Its frames are map, odom, base_link and laser, and those of an arm. All of it is recorded.
{end}"""
AT_CTRL_C = "Ctrl-C ends the demonstration."
AFTER = "It ends after {seconds:g} s."
NOBODY_WATCHES = "It has no terminal, so it ends after {seconds:g} s, or after --seconds N."
UNWATCHED_S = 15.0
"""Duration where neither a terminal nor a page shows the demonstration [s]."""
JOIN_IN = "Join in from another terminal: export ROS_DOMAIN_ID={domain_id}"
WIRE = "They meet over DDS, by libddsc {version} of {origin}."
OVER_ZENOH = "They meet over Zenoh."
ONE_PROCESS = "{reason}, so all programs run within this process, and other terminals can't join in{remedy}."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `demo`."""
    parser.add_argument(
        "which",
        nargs="?",
        choices=["turtles", "robot"],
        default="turtles",
        help="turtles that follow each other, or a robot that maps its room (default: turtles)",
    )
    parser.add_argument(
        "--seconds",
        type=seconds,
        metavar="N",
        help=f"end after this time (default: at Ctrl-C; without a terminal after {UNWATCHED_S:g} s)",
    )
    parser.add_argument(
        "--view", action="store_true", help="open the page of `tfloom view` in a browser, too"
    )


def main(args: argparse.Namespace) -> int:
    """Run the demonstration; return the exit code."""
    import signal

    from tfloom.cli.shared.errors import CommandError
    from tfloom.demos.program_group import ShowError
    from tfloom.viewer.extra import MISSING, is_installed

    if args.view and not is_installed():
        raise CommandError(MISSING.format(name="`tfloom demo --view`"))
    for name in ("SIGTERM", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.default_int_handler)
    try:
        description, has_processes = describe_wire()
        duration_s, end = describe_end(args.seconds, opens_page=args.view)
        is_robot = args.which == "robot"
        if is_robot and not has_processes:
            raise CommandError("`tfloom demo robot` needs a DDS library, because its programs are processes")
        print(f"{(ROBOT if is_robot else INTRODUCTION).format(end=end)}\n{description}")
        if is_robot:
            _show_robot(duration_s, opens_page=args.view)
        elif has_processes:
            _show_in_processes(duration_s, opens_page=args.view)
        elif args.view:
            raise CommandError("--view needs a DDS library, because the page is another process")
        else:
            _show_in_one_process(duration_s)
    except ShowError as error:
        raise CommandError(str(error)) from None
    except KeyboardInterrupt:
        print("The demonstration has ended.")
    return 0


def describe_end(requested_s: float | None, *, opens_page: bool) -> tuple[float | None, str]:
    """Return the demonstration's duration [s], None until Ctrl-C, and a sentence that says how it ends.

    Args:
        requested_s: The duration that the user has requested, if any.
        opens_page: Whether it is shown in a browser, too.
    """
    if requested_s is not None:
        return requested_s, AFTER.format(seconds=requested_s)
    has_terminal = any(stream is not None and stream.isatty() for stream in (sys.stdin, sys.stdout))
    if has_terminal or opens_page:
        return None, AT_CTRL_C
    return UNWATCHED_S, NOBODY_WATCHES.format(seconds=UNWATCHED_S)


def describe_wire() -> tuple[str, bool]:
    """Return a line on the wire of the demonstration, and whether processes can communicate over it."""
    from tfloom.rmw.cyclone.library import open_library
    from tfloom.rmw.errors import NoBackendError

    if os.environ.get("RMW_IMPLEMENTATION") == "tfloom_local":
        reason = "RMW_IMPLEMENTATION is tfloom_local, a wire within one process"
        return ONE_PROCESS.format(reason=reason, remedy=""), False
    if os.environ.get("RMW_IMPLEMENTATION") == "rmw_zenoh_cpp":
        return OVER_ZENOH, True
    try:
        library = open_library()
    except NoBackendError as error:
        reason = "No DDS library (libddsc) can be used"
        return ONE_PROCESS.format(reason=reason, remedy=f": {error}"), False
    return WIRE.format(version=library.version or "of unknown version", origin=library.origin), True


def _show_in_processes(seconds: float | None, *, opens_page: bool) -> None:
    from tfloom.demos.processes import own_domain, process_starter
    from tfloom.demos.show import PROGRAMS, VIEW, Show
    from tfloom.viewer.extra import is_installed

    programs = PROGRAMS | VIEW if is_installed() else PROGRAMS
    with own_domain() as domain_id:
        print(JOIN_IN.format(domain_id=domain_id))
        with Show(process_starter(domain_id), programs, opens_page=opens_page) as show:
            show.run(seconds)


def _show_robot(seconds: float | None, *, opens_page: bool) -> None:
    import contextlib
    from pathlib import Path

    from tfloom.demos.processes import own_domain, process_starter
    from tfloom.demos.robot_show import RobotShow, example_folder, new_recording
    from tfloom.viewer.extra import is_installed

    folder, recording = example_folder(), new_recording(Path.cwd())
    with own_domain() as domain_id:
        print(JOIN_IN.format(domain_id=domain_id))
        show = RobotShow(
            process_starter(domain_id), folder, recording, has_page=is_installed(), opens_page=opens_page
        )
        with contextlib.suppress(KeyboardInterrupt), show:
            show.run(seconds)
        show.compare()


def _show_in_one_process(seconds: float | None) -> None:
    from tfloom.demos.show import Show
    from tfloom.demos.threads import WINDOWLESS_PROGRAMS, thread_starter

    with thread_starter() as start, Show(start, WINDOWLESS_PROGRAMS) as show:
        show.run(seconds)
