"""Demonstrate turtlesim and tf2, in several processes on this machine, or in this process if there is no DDS."""

from __future__ import annotations

import argparse
import os

from tfloom.cli.numbers import seconds

INTRODUCTION = """\
One turtle draws a figure, with a laser mounted on it; another follows it by their transforms on tf.
Below is the output of `tf2_echo world laser`: the pose of the laser in the world. Ctrl-C ends the demonstration."""
JOIN_IN = "Join in from another terminal: export ROS_DOMAIN_ID={domain_id}"
WIRE = "They meet over DDS, by libddsc {version} of {origin}."
ONE_PROCESS = "{reason}, so all programs run within this process, and other terminals can't join in{remedy}."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `demo`."""
    parser.add_argument(
        "--seconds", type=seconds, metavar="N", help="end after this time (default: at Ctrl-C)"
    )
    parser.add_argument(
        "--view", action="store_true", help="open the page of `tfloom view` in a browser, too"
    )


def main(args: argparse.Namespace) -> int:
    """Run the demonstration; return the exit code."""
    import signal

    from tfloom.cli.errors import CommandError
    from tfloom.demos.show import ShowError
    from tfloom.viewer.extra import MISSING, is_installed

    if args.view and not is_installed():
        raise CommandError(MISSING.format(name="`tfloom demo --view`"))
    for name in ("SIGTERM", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.default_int_handler)
    try:
        description, is_over_dds = describe_wire()
        print(f"{INTRODUCTION}\n{description}")
        if is_over_dds:
            _show_over_dds(args.seconds, opens_page=args.view)
        elif args.view:
            raise CommandError("--view needs a DDS library, because the page is another process")
        else:
            _show_in_one_process(args.seconds)
    except ShowError as error:
        raise CommandError(str(error)) from None
    except KeyboardInterrupt:
        print("The demonstration has ended.")
    return 0


def describe_wire() -> tuple[str, bool]:
    """Return a line on the wire of the demonstration, and whether it is DDS, so that processes can communicate."""
    from tfloom.rmw.cyclone_library import open_library
    from tfloom.rmw.errors import NoBackendError

    if os.environ.get("RMW_IMPLEMENTATION") == "tfloom_local":
        reason = "RMW_IMPLEMENTATION is tfloom_local, a wire within one process"
        return ONE_PROCESS.format(reason=reason, remedy=""), False
    try:
        library = open_library()
    except NoBackendError as error:
        reason = "No DDS library (libddsc) can be used"
        return ONE_PROCESS.format(reason=reason, remedy=f": {error}"), False
    return WIRE.format(version=library.version or "of unknown version", origin=library.origin), True


def _show_over_dds(seconds: float | None, *, opens_page: bool) -> None:
    from tfloom.demos.processes import own_domain, process_starter
    from tfloom.demos.show import PROGRAMS, VIEW, Show
    from tfloom.viewer.extra import is_installed

    programs = PROGRAMS | VIEW if is_installed() else PROGRAMS
    with own_domain() as domain_id:
        print(JOIN_IN.format(domain_id=domain_id))
        with Show(process_starter(domain_id), programs, opens_page=opens_page) as show:
            show.run(seconds)


def _show_in_one_process(seconds: float | None) -> None:
    from tfloom.demos.show import Show
    from tfloom.demos.threads import WINDOWLESS_PROGRAMS, thread_starter

    with thread_starter() as start, Show(start, WINDOWLESS_PROGRAMS) as show:
        show.run(seconds)
