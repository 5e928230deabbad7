"""Write bags from others, with other settings."""

from __future__ import annotations

import argparse
from pathlib import Path

from tfloom.cli.bag import conventions


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `bag convert`."""
    parser.add_argument(
        "-i",
        "--input",
        required=True,
        action="append",
        nargs="+",
        metavar=("uri", "storage_id"),
        help="an input bag, and its storage, which is found by itself; may be given several times",
    )
    parser.add_argument(
        "-o",
        "--output-options",
        required=True,
        help="YAML file: under output_bags, a list of bags, each with its uri, storage_id, topics and other options",
    )


def main(args: argparse.Namespace) -> int:
    """Read the settings of the output bags, and write them from the input bags."""
    from tfloom.bag.converting import convert, read_outputs

    for words in args.input:
        if len(words) > 2:
            raise conventions.error(
                f"--input expects 1 or 2 arguments, {len(words)} provided: {' '.join(words)}"
            )
        if len(words) == 2 and words[1] not in conventions.STORAGES:
            raise conventions.error(
                f"Unknown storage '{words[1]}'; known are {', '.join(conventions.STORAGES)}"
            )
    with conventions.explained():
        outputs = read_outputs(Path(args.output_options))
        convert([Path(words[0]) for words in args.input], outputs)
    return 0
