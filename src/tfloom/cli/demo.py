"""Demonstrate turtlesim and tf2, in several processes on this machine, or in this process if there is no DDS."""

from __future__ import annotations

import argparse
import os
import sys

from tfloom.cli.numbers import seconds

INTRODUCTION = """\
One turtle draws a figure, with a laser mounted on it; another follows it by their transforms on tf.
Below is the output of `tf2_echo world laser`: the pose of the laser in the world. Ctrl-C ends the demonstration."""
JOIN_IN = "Join in from another terminal: export ROS_DOMAIN_ID={domain_id}"
ONE_PROCESS = "{reason}, so all programs run within this process, and other terminals can't join in."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `demo`."""
    parser.add_argument(
        "--seconds", type=seconds, metavar="N", help="end after this time (default: at Ctrl-C)"
    )


def main(args: argparse.Namespace) -> int:
    """Run the demonstration; return the exit code."""
    import signal

    from tfloom.cli.errors import CommandError
    from tfloom.demos.show import ShowError

    for name in ("SIGTERM", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.default_int_handler)
    try:
        reason = reason_for_one_process()
        if reason:
            _show_in_one_process(reason, args.seconds)
        else:
            _show_over_dds(args.seconds)
    except ShowError as error:
        raise CommandError(str(error)) from None
    except KeyboardInterrupt:
        print("The demonstration has ended.")
    return 0


def reason_for_one_process() -> str:
    """Return why processes can't communicate; empty if they can, over DDS."""
    import platform

    from tfloom.rmw.backends import is_installed

    if os.environ.get("RMW_IMPLEMENTATION") == "tfloom_local":
        return "RMW_IMPLEMENTATION is tfloom_local, a wire within one process"
    if is_installed("rmw_cyclonedds_cpp"):
        return ""
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    where = f"{platform.system()} {platform.machine()}"
    return f"The library cyclonedds (version 11), which implements DDS, is missing for Python {version} on {where}"


def _show_over_dds(seconds: float | None) -> None:
    from tfloom.demos.processes import own_domain, process_starter
    from tfloom.demos.show import Show

    with own_domain() as domain_id:
        print(f"{INTRODUCTION}\n{JOIN_IN.format(domain_id=domain_id)}")
        with Show(process_starter(domain_id)) as show:
            show.run(seconds)


def _show_in_one_process(reason: str, seconds: float | None) -> None:
    from tfloom.demos.show import Show
    from tfloom.demos.threads import WINDOWLESS_PROGRAMS, thread_starter

    print(f"{INTRODUCTION}\n{ONE_PROCESS.format(reason=reason)}")
    with thread_starter() as start, Show(start, WINDOWLESS_PROGRAMS) as show:
        show.run(seconds)
