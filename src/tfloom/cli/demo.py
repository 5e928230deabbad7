"""Demonstrate turtlesim and tf2, or a robot that maps its room.

The programs are processes on this machine; those with turtles are threads of this process if there is no DDS.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from tfloom.cli.shared.numbers import seconds
from tfloom.common.terminal import shown_part

INTRODUCTION = """\
One turtle draws a figure, with a laser mounted on it; another follows it by their transforms on tf.
Below is the output of `tf2_echo world laser`: the pose of the laser in the world.
{end}"""
ROBOT = """\
A simulated robot drives round its room. Its odometry drifts, and a node corrects it by the scans of a laser, which it
draws into a map. Its frames are map, odom, base_link and laser, and those of an arm.
{end}"""
RECORDED = "All of it is recorded, up to {size_mb} MB."
AT_CTRL_C = "Ctrl-C ends the demonstration."
UNDER_MAKE = " (`make` then prints `Interrupt`, which is not a failure.)"
AFTER = "It ends after {seconds:g} s."
NOBODY_WATCHES = "It has no terminal, so it ends after {seconds:g} s, or after --seconds N."
UNWATCHED_S = 15.0
"""Duration where neither a terminal nor a page shows the demonstration [s]."""
JOIN_IN = "Join in from another terminal: export ROS_DOMAIN_ID={domain_id}"
ON_DOMAIN = "It runs on domain {domain_id}, as ROS_DOMAIN_ID says."
ON_DEFAULT_DOMAIN = "It runs on domain {domain_id}, because ROS_DOMAIN_ID isn't set."
OTHERS = (
    "on domain {domain_id} are already: {names}. The demonstration would drive them, too: unset ROS_DOMAIN_ID, or set "
    "another one, or add --here"
)
MAX_NAMES = 5
"""Number of other nodes that are named."""
DISCOVERY_S = 1.0
"""The longest time in which others are looked for [s]."""
WIRE = "They meet over DDS, by libddsc {version} of {origin}."
BESIDE_ZENOH = " RMW_IMPLEMENTATION is left aside: over Zenoh they would need a router."
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
    parser.add_argument(
        "--here",
        action="store_true",
        help="run on the domain of ROS_DOMAIN_ID though other nodes are there, which it then drives, too",
    )
    parser.add_argument(
        "--no-record", action="store_true", help="of the robot: don't record, and don't compare at the end"
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
            _show_robot(args, duration_s)
        elif has_processes:
            _show_in_processes(args, duration_s)
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
        return None, AT_CTRL_C + (UNDER_MAKE if "MAKELEVEL" in os.environ else "")
    return UNWATCHED_S, NOBODY_WATCHES.format(seconds=UNWATCHED_S)


def describe_wire() -> tuple[str, bool]:
    """Return a line on the wire of the demonstration, and whether processes can communicate over it."""
    from tfloom.rmw.cyclone.library import open_library
    from tfloom.rmw.errors import NoBackendError

    if os.environ.get("RMW_IMPLEMENTATION") == "tfloom_local":
        reason = "RMW_IMPLEMENTATION is tfloom_local, a wire within one process"
        return ONE_PROCESS.format(reason=reason, remedy=""), False
    try:
        library = open_library()
    except NoBackendError as error:
        reason = "No DDS library (libddsc) can be used"
        return ONE_PROCESS.format(reason=reason, remedy=f": {error}"), False
    wire = WIRE.format(version=library.version or "of unknown version", origin=library.origin)
    return wire + (BESIDE_ZENOH if os.environ.get("RMW_IMPLEMENTATION") == "rmw_zenoh_cpp" else ""), True


@contextmanager
def _domain(*, is_shared: bool) -> Iterator[int]:
    """Give, for the block, the domain of ROS_DOMAIN_ID, or one on which nobody is.

    Args:
        is_shared: Whether other nodes may be on the domain of ROS_DOMAIN_ID, which is then 0 where it isn't set.

    Raises:
        CommandError: others are there.
        ConfigurationError: ROS_DOMAIN_ID is not a domain.
    """
    from tfloom.cli.shared.errors import CommandError
    from tfloom.demos.processes import own_domain
    from tfloom.rmw.backends import domain_id_from_environment

    if not (is_shared or os.environ.get("ROS_DOMAIN_ID")):
        with own_domain(lambda domain_id: not nodes_on(domain_id)) as domain_id:
            print(JOIN_IN.format(domain_id=domain_id))
            yield domain_id
        return
    domain_id = domain_id_from_environment()
    if not is_shared and (found := nodes_on(domain_id)):
        names = ", ".join(map(shown_part, found[:MAX_NAMES]))
        more = f" and {len(found) - MAX_NAMES} more" if len(found) > MAX_NAMES else ""
        raise CommandError(OTHERS.format(domain_id=domain_id, names=f"{names}{more}"))
    is_set = bool(os.environ.get("ROS_DOMAIN_ID"))
    print((ON_DOMAIN if is_set else ON_DEFAULT_DOMAIN).format(domain_id=domain_id))
    yield domain_id


def nodes_on(domain_id: int) -> list[str]:
    """Return the names of the nodes that a program finds on a DDS domain as those of the demonstration would."""
    from tfloom.cli.shared.graph import wait_until_quiet
    from tfloom.demos.processes import ENVIRONMENT, environment_set
    from tfloom.rmw.backends import open_participant

    with environment_set(ENVIRONMENT):
        participant = open_participant(domain_id)
    try:
        wait_until_quiet(participant.graph, DISCOVERY_S, goes_on=True)
        return sorted({node.full for node in participant.graph.nodes() if not node.name.startswith("_")})
    finally:
        participant.close()


def _show_in_processes(args: argparse.Namespace, seconds: float | None) -> None:
    from tfloom.demos.processes import process_starter
    from tfloom.demos.show import PROGRAMS, VIEW, Show
    from tfloom.viewer.extra import is_installed

    programs = PROGRAMS | VIEW if is_installed() else PROGRAMS
    with (
        _domain(is_shared=args.here) as domain_id,
        Show(process_starter(domain_id), programs, opens_page=args.view) as show,
    ):
        show.run(seconds)


def _show_robot(args: argparse.Namespace, seconds: float | None) -> None:
    import contextlib
    from pathlib import Path

    from tfloom.demos.processes import process_starter
    from tfloom.demos.robot_show import MAX_RECORDING_MB, RobotShow, example_folder, new_recording
    from tfloom.viewer.extra import is_installed

    folder = example_folder()
    recording = None if args.no_record else new_recording(Path.cwd())
    if recording is not None:
        print(RECORDED.format(size_mb=MAX_RECORDING_MB))
    with _domain(is_shared=args.here) as domain_id:
        show = RobotShow(
            process_starter(domain_id), folder, recording, has_page=is_installed(), opens_page=args.view
        )
        with contextlib.suppress(KeyboardInterrupt), show:
            show.run(seconds)
        show.compare()


def _show_in_one_process(seconds: float | None) -> None:
    from tfloom.demos.show import Show
    from tfloom.demos.threads import WINDOWLESS_PROGRAMS, thread_starter

    with thread_starter() as start, Show(start, WINDOWLESS_PROGRAMS) as show:
        show.run(seconds)
