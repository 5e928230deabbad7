"""Draw position and yaw of one frame in another over time."""

from __future__ import annotations

import argparse
import shlex
import time
from pathlib import Path
from typing import TYPE_CHECKING

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.numbers import seconds
from tfloom.cli.tf import source
from tfloom.common.terminal import report
from tfloom.tf2_tools.text import counted

if TYPE_CHECKING:
    from tfloom.tf2.buffer import Buffer
    from tfloom.tf2_tools.watch.sources import Source

FORMATS = (".pdf", ".png", ".svg")
RECORD_S = 10.0
LOOK_S = 0.2
"""How often a wait for the first transform looks [s]."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `tf plot`."""
    parser.add_argument("target_frame", help="the frame in which the other one is shown")
    parser.add_argument("source_frame", help="the frame that moves")
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        type=_output,
        default="tf_plot.png",
        help=f"the picture: {', '.join(FORMATS)} (default: tf_plot.png)",
    )
    parser.add_argument(
        "--seconds",
        metavar="S",
        type=seconds,
        default=RECORD_S,
        help=f"how long to record a live graph in seconds; Ctrl-C ends it earlier (default: {RECORD_S:g})",
    )
    parser.add_argument("--rpy", action="store_true", help="draw roll and pitch, too")
    source.add_arguments(parser)


def _output(text: str) -> Path:
    """Return the path of a picture.

    Raises:
        argparse.ArgumentTypeError: its ending is not a picture's, or there is no such folder.
    """
    path = Path(text)
    if path.suffix.lower() not in FORMATS:
        raise argparse.ArgumentTypeError(f"{text!r} must end in {', '.join(FORMATS[:-1])} or {FORMATS[-1]}")
    if not path.parent.is_dir():
        raise argparse.ArgumentTypeError(f"there is no folder {path.parent}")
    return path


def main(args: argparse.Namespace) -> int:
    """Write the picture, and print what it shows; fail if there is no transform between the frames."""
    from tfloom.common.files import write_file
    from tfloom.tf2.buffer import Buffer
    from tfloom.tf2.errors import TransformException
    from tfloom.tf2_tools.motion import motion_of

    buffer = Buffer(None)
    buffer.set_log_callback(None)
    with source.open_source(args, buffer=buffer) as opened:
        if source.is_live(args.bag):
            _record(opened, buffer, args)
    try:
        motion = motion_of(buffer, args.target_frame, args.source_frame)
    except TransformException as error:
        raise CommandError(f"{str(error).rstrip()} {_advice(args)}") from None
    if not len(motion.times_ns):
        raise CommandError(
            f"{args.source_frame} does not move in {args.target_frame}: all transforms between them are static"
        )
    from tfloom.tf2_tools.chart import chart
    from tfloom.tf2_tools.drawing.formats import file_content

    place = source.place(args.bag)
    where = f"live, {place}" if source.is_live(args.bag) else place
    picture = chart(motion, where, all_angles=args.rpy)
    write_file(args.output, file_content([picture], args.output.suffix.lower().removeprefix(".")))
    gaps = f", {len(motion.gaps_ns)} without data" if motion.gaps_ns else ""
    print(f"{args.output}: {counted(len(motion.times_ns), 'sample')} in {motion.duration_s:.3f} s{gaps}")
    return 0


def _record(opened: Source, buffer: Buffer, args: argparse.Namespace) -> None:
    """Wait until the frames are connected, then record; Ctrl-C ends the recording."""
    frames = args.target_frame, args.source_frame
    end_s = time.monotonic() + args.wait
    while not buffer.can(*frames) and time.monotonic() < end_s:
        opened.wait(min(end_s, time.monotonic() + LOOK_S))
    if not buffer.can(*frames) or all(edge.is_static for edge in buffer.explain(*frames).edges):
        return
    report(f"recording for {args.seconds:g} s; Ctrl-C ends it earlier")
    end_s = time.monotonic() + args.seconds
    try:
        while (left_s := end_s - time.monotonic()) > 0.0:
            time.sleep(left_s)
    except KeyboardInterrupt:
        return


def _advice(args: argparse.Namespace) -> str:
    where = [] if source.is_live(args.bag) else ["--bag", args.bag]
    return f"Try: {shlex.join(['tfloom', 'tf', 'explain', args.target_frame, args.source_frame, *where])}"
