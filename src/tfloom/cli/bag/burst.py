"""Publish messages of a bag at once, then pause."""

from __future__ import annotations

import argparse

from tfloom.cli.bag import conventions, play_arguments
from tfloom.cli.parser import help_since
from tfloom.cli.shared import numbers


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `bag burst`."""
    play_arguments.add_path(parser)
    parser.add_argument("--topics", nargs="+", default=[], help="topics to play (default: all)")
    parser.add_argument("--services", nargs="+", default=[], help="services to play (default: all)")
    parser.add_argument(
        "--actions",
        nargs="+",
        default=[],
        help=help_since("kilted", "actions to play (default: all)"),
    )
    play_arguments.add_qos_overrides(parser)
    play_arguments.add_remap(parser)
    play_arguments.add_storage_config(parser)
    play_arguments.add_start_offset(parser)
    parser.add_argument(
        "-n",
        "--num-messages",
        type=numbers.count,
        default=0,
        help="number of messages to publish (default 0: all)",
    )


def main(args: argparse.Namespace) -> int:
    """Publish the messages, then go on from the keyboard or by services, until Ctrl-C."""
    with conventions.explained():
        options = play_arguments.common_options(args)
        options.is_start_paused = True
        with conventions.running_context("info"):
            from tfloom.bag.playing.run import play

            play(play_arguments.paths_of(args), options, burst=args.num_messages)
    return 0
