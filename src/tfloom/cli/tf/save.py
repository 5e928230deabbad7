"""Write the static transforms of a live graph or a bag to a file."""

from __future__ import annotations

import argparse
import sys
from typing import TextIO

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.tf import source
from tfloom.common.terminal import report
from tfloom.tf2_tools.text import counted


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `tf save`."""
    parser.add_argument("file", help="the file to write, in YAML; - is standard output")
    source.add_arguments(parser)


def main(args: argparse.Namespace) -> int:
    """Write the file; fail if there is no static transform."""
    from tfloom.common.files import write_file
    from tfloom.tf2_tools.static_file import file_text
    from tfloom.tf2_tools.watch.statics import last_statics, quarrels, unusable

    with source.open_source(args) as opened:
        seen = source.settled(opened, args.wait, only_static=True)
    for sentence in unusable(seen):
        report(f"WARNING: {sentence}")
    transforms = last_statics(seen)
    if not transforms:
        raise CommandError(_why_none(args))
    for sentence in quarrels(seen):
        report(f"WARNING: {sentence}")
    for publisher in seen.publishers:
        if publisher.is_static and publisher.traffic is None:
            report(f"WARNING: nothing came from {publisher.label} on {publisher.topic}")
    if args.file == "-":
        print(file_text(transforms, ascii_only=not _writes_all_letters(sys.stdout)), end="")
        return 0
    write_file(args.file, file_text(transforms))
    print(f"{args.file}: {counted(len(transforms), 'static transform')}")
    return 0


def _writes_all_letters(stream: TextIO) -> bool:
    """Return whether a stream writes each letter as it is, not as an escape sequence that YAML would not read back."""
    return stream.encoding.lower().replace("-", "").startswith("utf")


def _why_none(args: argparse.Namespace) -> str:
    if not source.is_live(args.bag):
        return f"{args.bag}: there is no static transform in it"
    return f"no static transform on {args.tf_static_topic}: waited {args.wait:g} s"
