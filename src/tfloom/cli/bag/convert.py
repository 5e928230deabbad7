"""Write bags from others, with other settings."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tfloom.cli.bag import conventions
from tfloom.cli.parser import help_since
from tfloom.ros_imports import ros_distro


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `bag convert`."""
    inputs = parser.add_argument(
        "-i",
        "--input",
        required=not ros_distro.since("lyrical"),
        default=[],
        action="append",
        nargs="+",
        metavar=("uri", "storage_id"),
        help="an input bag, and its storage, which is found by itself; may be given several times",
    )
    parser.add_argument(
        "--input-options",
        action=_InPlaceOf,
        replaced=inputs,
        help=help_since(
            "lyrical", "YAML file: under input_bags, a list of bags, each with its uri and storage_id"
        ),
    )
    parser.add_argument(
        "-o",
        "--output-options",
        required=True,
        help="YAML file: under output_bags, a list of bags, each with its uri, storage_id, topics and other options",
    )


class _InPlaceOf(argparse.Action):
    """Stores a value; then another argument needn't be given, which the usage text shows as required."""

    def __init__(self, *args: Any, replaced: argparse.Action, **options: Any) -> None:
        super().__init__(*args, **options)
        self._replaced = replaced

    def __call__(
        self,
        parser: argparse.ArgumentParser,  # noqa: ARG002 - as argparse calls it
        namespace: argparse.Namespace,
        values: Any,
        option_string: str | None = None,  # noqa: ARG002
    ) -> None:
        self._replaced.required = False
        setattr(namespace, self.dest, values)


def main(args: argparse.Namespace) -> int:
    """Read the settings of the output bags, and write them from the input bags."""
    from tfloom.bag.converting import convert, read_inputs, read_outputs

    # A program that runs the verb's class may leave out what the parser requires.
    inputs = _named_inputs(getattr(args, "input", []))
    with conventions.explained():
        if args.input_options is not None:
            inputs += read_inputs(Path(args.input_options))
        if not inputs:
            raise conventions.error("no input bag: name one by -i, or in the file of --input-options")
        convert(inputs, read_outputs(Path(args.output_options)))
    return 0


def _named_inputs(given: Sequence[Sequence[str]]) -> list[Path]:
    """Return the paths of the input bags, each given by one or two words.

    Raises:
        CommandError: there are more words, or the second one is not a storage.
    """
    for words in given:
        if len(words) > 2:
            raise conventions.error(
                f"--input expects 1 or 2 arguments, {len(words)} provided: {' '.join(words)}"
            )
        if len(words) == 2 and words[1] not in conventions.STORAGES:
            raise conventions.error(
                f"Unknown storage '{words[1]}'; known are {', '.join(conventions.STORAGES)}"
            )
    return [Path(words[0]) for words in given]
