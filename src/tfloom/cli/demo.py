"""Show turtlesim and tf2 at work, in processes of their own on this machine."""

from __future__ import annotations

import argparse
from pathlib import Path

from tfloom.cli.numbers import seconds

INTRODUCTION = """\
One turtle draws a figure, with a laser mounted on it; another follows it by what tf tells of the two.
Below is what `tf2_echo world laser` sees: the laser in the world. Ctrl-C ends it all.
Join in from another terminal: export ROS_DOMAIN_ID={domain_id}"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what `demo` takes."""
    parser.add_argument(
        "--seconds", type=seconds, metavar="N", help="how long to go on (default: until Ctrl-C)"
    )


def main(args: argparse.Namespace) -> int:
    """Run the demonstration; return the exit code."""
    import signal

    from tfloom.cli.errors import CommandError
    from tfloom.demos.show import Show, ShowError, own_domain

    for name in ("SIGTERM", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.default_int_handler)
    try:
        with own_domain() as domain_id:
            print(INTRODUCTION.format(domain_id=domain_id))
            with Show(domain_id, Path.cwd()) as show:
                show.run(args.seconds)
    except ShowError as error:
        raise CommandError(str(error)) from None
    except KeyboardInterrupt:
        print("The demonstration has ended.")
    return 0
