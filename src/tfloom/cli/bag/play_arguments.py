"""The flags that `bag play` and `bag burst` have."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from tfloom.cli.bag import conventions
from tfloom.cli.parser import help_since
from tfloom.cli.shared import numbers

if TYPE_CHECKING:
    from tfloom.bag.playing.play_options import PlayOptions
    from tfloom.bag.topic_choice import TopicChoice


class _Formatter(argparse.HelpFormatter):
    """Shows the path as needed, which it is without `-i`."""

    def _format_args(self, action: argparse.Action, default_metavar: str) -> str:
        return action.dest if action.dest == "bag_path" else super()._format_args(action, default_metavar)


def add_path(parser: argparse.ArgumentParser) -> None:
    """Add the bag or bags, the storage, and how much is read ahead."""
    parser.formatter_class = _Formatter
    parser.add_argument("bag_path", type=conventions.bag_path, nargs="?", help="the bag: a folder, or a file")
    parser.add_argument(
        "-i",
        "--input",
        action="append",
        nargs="+",
        default=[],
        metavar=("uri", "storage_id"),
        help=help_since(
            "kilted", "a bag, and its storage if it is to be given; once for each of several bags"
        ),
    )
    conventions.add_storage(parser)
    parser.add_argument(
        "--read-ahead-queue-size",
        type=numbers.count,
        default=1000,
        help="number of messages that are read ahead, fewer of large ones (default 1000)",
    )


def paths_of(args: argparse.Namespace) -> list[Path]:
    """Return the bags that are played.

    Raises:
        CommandError: there is none, one doesn't exist, or the arguments of one are wrong.
    """
    if args.bag_path and args.input:
        raise conventions.error("a bag is named by its path or by -i, not by both")
    if not args.bag_path and not args.input:
        raise conventions.error("needs a bag: its path, or -i with the path of each of several")
    paths = [Path(args.bag_path)] if args.bag_path else []
    for uri, *storage in args.input:
        if len(storage) > 1 or not {*storage} <= {*conventions.STORAGES}:
            raise conventions.error(
                f"-i needs a path and a storage, {' or '.join(conventions.STORAGES)}, at most"
            )
        try:
            paths.append(Path(conventions.bag_path(uri)))
        except argparse.ArgumentTypeError as problem:
            raise conventions.error(str(problem)) from None
    return paths


def add_qos_overrides(parser: argparse.ArgumentParser) -> None:
    """Add the flag for other QoS profiles."""
    parser.add_argument(
        "--qos-profile-overrides-path",
        type=conventions.existing_file,
        help="YAML file with a QoS profile for each topic whose recorded one isn't wanted",
    )


def add_remap(parser: argparse.ArgumentParser) -> None:
    """Add the flag for other names."""
    parser.add_argument(
        "--remap", "-m", nargs="+", default=[], help="other names of topics: old_topic:=new_topic …"
    )


def add_storage_config(parser: argparse.ArgumentParser) -> None:
    """Add the flag for a configuration of the storage."""
    parser.add_argument(
        "--storage-config-file",
        type=conventions.existing_file,
        help="accepted and not used: reading has no options",
    )


def add_start_offset(parser: argparse.ArgumentParser) -> None:
    """Add the flag for the time at which playing starts."""
    parser.add_argument(
        "--start-offset",
        type=numbers.seconds,
        default=0.0,
        help="start this many seconds after the bag's start (default 0); what transient local topics held then is "
        "published first",
    )


def choice_of(args: argparse.Namespace) -> TopicChoice:
    """Return which topics are played: without --topics, --services, --actions and --regex, all."""
    from tfloom.bag.topic_choice import TopicChoice, full_names

    regex = getattr(args, "regex", "")
    wants_all = not (args.topics or args.services or args.actions or regex)
    return TopicChoice(
        topics=full_names(args.topics),
        services=full_names(args.services),
        actions=full_names(args.actions),
        all_topics=wants_all,
        all_services=wants_all,
        regex=regex,
        exclude_regex=getattr(args, "exclude_regex", ""),
        exclude_topics=full_names(getattr(args, "exclude_topics", [])),
        exclude_services=full_names(getattr(args, "exclude_services", [])),
        exclude_actions=full_names(getattr(args, "exclude_actions", [])),
    )


def common_options(args: argparse.Namespace) -> PlayOptions:
    """Return the options of the flags of this file.

    Raises:
        BagError: the file with QoS profiles can't be used.
        CommandError: a remap is malformed.
    """
    from tfloom.bag.playing.play_options import PlayOptions, parse_remaps
    from tfloom.bag.qos_profiles import read_overrides

    try:
        remaps = parse_remaps(args.remap)
    except ValueError as problem:
        raise conventions.error(str(problem)) from None
    overrides = args.qos_profile_overrides_path
    return PlayOptions(
        choice=choice_of(args),
        remaps=remaps,
        start_offset_s=args.start_offset,
        qos_overrides=read_overrides(overrides) if overrides else {},
        read_ahead=args.read_ahead_queue_size,
    )
