"""Publish the messages of a bag, at the pace at which they were recorded."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from tfloom.cli.bag import conventions, play_arguments
from tfloom.cli.parser import help_since
from tfloom.cli.shared import numbers
from tfloom.ros_imports.ros_distro import PLAY_SHOWS_PROGRESS

if TYPE_CHECKING:
    from tfloom.bag.playing.play_options import PlayOptions

DEFAULT_CLOCK_HZ = 40.0
DEFAULT_PROGRESS_HZ = 3


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `bag play`."""
    play_arguments.add_path(parser)
    parser.add_argument(
        "-r",
        "--rate",
        type=numbers.positive,
        default=1.0,
        help="seconds of the bag in a second, above 0 (default 1)",
    )
    _add_choice(parser)
    play_arguments.add_qos_overrides(parser)
    parser.add_argument("-l", "--loop", action="store_true", help="start again at the end")
    play_arguments.add_remap(parser)
    play_arguments.add_storage_config(parser)
    _add_clock(parser)
    parser.add_argument(
        "-d",
        "--delay",
        type=numbers.seconds,
        default=0.0,
        help="wait before playing, in each loop, in seconds (default 0)",
    )
    _add_limits(parser)
    parser.add_argument("--disable-keyboard-controls", action="store_true", help="ignore the keyboard")
    parser.add_argument("-p", "--start-paused", action="store_true", help="begin in the paused state")
    play_arguments.add_start_offset(parser)
    parser.add_argument(
        "--wait-for-all-acked",
        type=numbers.count,
        default=-1,
        metavar="TIMEOUT",
        help="at the end, wait for this many milliseconds until reliable subscriptions have received all; 0: no limit",
    )
    parser.add_argument(
        "--disable-loan-message", action="store_true", help="accepted and not used: no message is loaned"
    )
    _add_requests(parser)
    _add_order_and_progress(parser)
    parser.add_argument(
        "--log-level", choices=conventions.LOG_LEVELS, default="info", help="least level of what is printed"
    )


def _add_choice(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--topics", nargs="+", default=[], metavar="topic", help="topics to play (default: all)")
    add("--services", nargs="+", default=[], metavar="service", help="services to play (default: all)")
    add(
        "--actions",
        nargs="+",
        default=[],
        metavar="action",
        help=help_since("kilted", "actions to play (default: all)"),
    )
    add(
        "-e",
        "--regex",
        type=conventions.regular_expression,
        default="",
        help="play topics and services in whose names this is found",
    )
    add(
        "-x",
        "--exclude-regex",
        type=conventions.regular_expression,
        default="",
        help="leave out topics and services in whose names this is found",
    )
    add("--exclude-topics", nargs="+", default=[], metavar="topic", help="topics to leave out")
    add("--exclude-services", nargs="+", default=[], metavar="service", help="services to leave out")
    add(
        "--exclude-actions",
        nargs="+",
        default=[],
        metavar="action",
        help=help_since("kilted", "actions to leave out"),
    )


def _add_clock(parser: argparse.ArgumentParser) -> None:
    group = parser.add_mutually_exclusive_group()
    group.add_argument(
        "--clock",
        type=numbers.positive,
        nargs="?",
        const=DEFAULT_CLOCK_HZ,
        default=0.0,
        help=f"publish the bag's time on /clock at this frequency in hertz (without a number: {DEFAULT_CLOCK_HZ:g}), "
        "in place of a recorded /clock",
    )
    group.add_argument(
        "--clock-topics", nargs="+", default=[], help="publish /clock before each message of these topics"
    )
    group.add_argument("--clock-topics-all", action="store_true", help="publish /clock before each message")


def _add_limits(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--playback-duration",
        type=numbers.finite,
        default=-1.0,
        help="play this many seconds of the bag; negative: all (default -1). The later of two limits counts",
    )
    group = parser.add_mutually_exclusive_group()
    group.add_argument(
        "--playback-until-sec",
        type=numbers.finite,
        default=-1.0,
        help="play until this stamp in seconds since the epoch; negative: all (default -1)",
    )
    group.add_argument(
        "--playback-until-nsec",
        type=numbers.whole,
        default=-1,
        help="play until this stamp in nanoseconds since the epoch; negative: all (default -1)",
    )


def _add_requests(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--publish-service-requests",
        action="store_true",
        help="send the recorded requests to the services, in place of publishing the recorded events",
    )
    parser.add_argument(
        "--send-actions-as-client",
        action="store_true",
        help=help_since(
            "kilted",
            "send the recorded goals, cancellations and result requests to the action servers, in place of publishing "
            "what is recorded of the actions",
        ),
    )
    parser.add_argument(
        "--service-requests-source",
        choices=["service_introspection", "client_introspection"],
        default="service_introspection",
        help="whose recorded requests and goals are sent (default: the services')",
    )


def _add_order_and_progress(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--message-order",
        choices=["received", "sent"],
        default="received",
        help=help_since("kilted", "by which of their times messages are played (default received)"),
    )
    parser.add_argument(
        "--progress-bar-update-rate",
        type=numbers.whole,
        default=DEFAULT_PROGRESS_HZ if PLAY_SHOWS_PROGRESS else 0,
        help=help_since(
            "kilted",
            "how often the progress is shown on a terminal, in hertz; negative: with each message; 0: never "
            f"(default {DEFAULT_PROGRESS_HZ})",
        ),
    )
    parser.add_argument(
        "--progress-bar-separation-lines",
        type=numbers.count,
        default=2,
        help=help_since("kilted", "number of empty lines between logs and progress (default 2)"),
    )


def main(args: argparse.Namespace) -> int:
    """Play until the bag's end, or Ctrl-C."""
    paths = play_arguments.paths_of(args)
    with conventions.explained():
        options = _options(args)
        with conventions.running_context(args.log_level):
            from tfloom.bag.playing.run import play

            play(paths, options)
    return 0


def _options(args: argparse.Namespace) -> PlayOptions:
    from tfloom.bag.topic_choice import full_names

    options = play_arguments.common_options(args)
    options.rate = args.rate
    options.is_loop = args.loop
    options.clock_hz = args.clock
    options.clock_topics = full_names(args.clock_topics)
    options.is_clock_on_all = args.clock_topics_all
    options.delay_s = args.delay
    options.duration_s = args.playback_duration
    until_s = args.playback_until_sec
    options.until_ns = args.playback_until_nsec if until_s < 0.0 else int(until_s * 1e9)
    options.is_start_paused = args.start_paused
    options.wait_acked_ms = args.wait_for_all_acked
    options.has_keyboard = not args.disable_keyboard_controls
    options.publishes_requests = args.publish_service_requests
    options.sends_goals = args.send_actions_as_client
    options.is_client_source = args.service_requests_source == "client_introspection"
    options.is_by_sent_time = args.message_order == "sent"
    options.progress_hz = args.progress_bar_update_rate
    options.progress_lines = args.progress_bar_separation_lines
    return options
