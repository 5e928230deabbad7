"""Write the metadata of a bag anew, from its files."""

from __future__ import annotations

import argparse
from pathlib import Path

from tfloom.cli.bag import conventions


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `bag reindex`."""
    parser.add_argument("bag_path", type=conventions.bag_path, help="the bag's folder")
    conventions.add_storage(parser)


def main(args: argparse.Namespace) -> int:
    """Write metadata.yaml anew, from what the files of the bag hold."""
    from tfloom.bag.reindexing import reindex

    path = Path(args.bag_path)
    if not path.is_dir():
        raise conventions.error("Must specify a bag directory")
    with conventions.explained():
        reindex(path, args.storage)
    return 0
