"""The verbs of `bag` that print what is there, or write its metadata anew."""

from __future__ import annotations

import argparse
from pathlib import Path

from tfloom.cli.bag import conventions
from tfloom.cli.parser import help_since
from tfloom.cli.shared.errors import CommandError


def add_info_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `bag info`."""
    parser.add_argument("bag_path", type=conventions.bag_path, help="the bag: a folder, or a file")
    conventions.add_storage(parser)
    parser.add_argument("-t", "--topic-name", action="store_true", help="print the topics' names only")
    parser.add_argument(
        "--sort",
        choices=["name", "type", "count"],
        default="",
        help=help_since("kilted", "order of the topics (default: that of the metadata)"),
    )
    parser.add_argument(
        "--size-contribution",
        action="store_true",
        help=help_since(
            "kilted", "print the size of each topic's messages, and its share; reads the whole bag"
        ),
    )
    parser.add_argument(
        "-v", "--verbose", action="store_true", help="count the requests and responses of services"
    )


def info_main(args: argparse.Namespace) -> int:
    """Print what is known of the bag."""
    from tfloom.bag.metadata import METADATA_FILE
    from tfloom.bag.opening import open_bag

    path = Path(args.bag_path)
    if path.is_dir() and not (path / METADATA_FILE).exists():
        hint = f"`ros2 bag reindex {args.bag_path}` writes one from its files"
        raise CommandError(f"Could not find metadata in bag directory {args.bag_path}\n{hint}")
    with conventions.explained(), open_bag(path) as bag:
        if args.topic_name:
            _print_names(list(bag.topics))
        else:
            from tfloom.bag.info_text import info_text

            print(
                info_text(bag, verbose=args.verbose, sort=args.sort, size_contribution=args.size_contribution)
            )
    return 0


def _print_names(names: list[str]) -> None:
    for name in sorted(names):
        print(name)


KINDS = {
    "storage": {
        "mcap": "messages in chunks, which may be compressed, with indexes",
        "sqlite3": "messages in a table of a database",
    },
    "converter": {},
    "compressor": {"zstd": "compresses files, or each message"},
    "decompressor": {"zstd": "decompresses files, or each message"},
}


def add_list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `bag list`."""
    parser.add_argument("plugin_type", choices=list(KINDS), help="the kind to list")
    parser.add_argument("-v", "--verbose", action="store_true", help="print what each one does")


def list_main(args: argparse.Namespace) -> int:
    """Print the names of the storage plugins of one kind."""
    for name, text in KINDS[args.plugin_type].items():
        print(f"{name}: {text}" if args.verbose else name)
    return 0


def add_reindex_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `bag reindex`."""
    parser.add_argument("bag_path", type=conventions.bag_path, help="the bag's folder")
    conventions.add_storage(parser)


def reindex_main(args: argparse.Namespace) -> int:
    """Write metadata.yaml anew, from what the files of the bag hold."""
    from tfloom.bag.reindexing import reindex

    path = Path(args.bag_path)
    if not path.is_dir():
        raise conventions.error("Must specify a bag directory")
    with conventions.explained():
        reindex(path, args.storage)
    return 0
