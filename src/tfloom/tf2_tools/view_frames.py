"""view_frames: listen to all transforms for a while, then write the tree as a text for Graphviz and as pictures."""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

from tfloom.common.files import write_file
from tfloom.node.client_library import spin_once
from tfloom.node.context.utilities import ok, remove_ros_args
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.rmw.base import NodeName
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener
from tfloom.tf2_tools.static_file import StaticFileError
from tfloom.tf2_tools.tree_pictures.records import FrameRecord, parse_frames_yaml, write_gv
from tfloom.tf2_tools.tree_pictures.tree import FrameTree, build_tree, tree_json
from tfloom.tf2_tools.watch.live import LiveWatch
from tfloom.tf2_tools.watch.model import Observation

COPY_NAME = "frames.pdf"
"""The name of the file in tutorials."""
FORMATS = ("gv", "html", "json", "pdf", "png", "svg")
"""Endings of the files that `--format` names."""
DEFAULT_FORMATS = ("gv", "pdf")
MAX_WAIT_S = 1e9
"""Longer ones, also an infinite one, are reduced to this, which 64 bits of nanoseconds hold [s]."""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    """Read a command line without its ROS arguments; exit with a usage text if it is invalid."""
    parser = argparse.ArgumentParser(
        prog="view_frames",
        description="Listen to /tf and /tf_static, then draw the tree of the received frames: NAME.gv is its "
        f"text for Graphviz, NAME.pdf and {COPY_NAME} are its picture, all in the current folder.",
    )
    parser.add_argument(
        "-t", "--wait-time", type=float, default=5.0, metavar="S", help="how long to listen [s] (default: 5)"
    )
    parser.add_argument(
        "-o", "--output", metavar="NAME", help="name of the files (default: frames_ and the date and time)"
    )
    parser.add_argument(
        "--format",
        action="append",
        type=_formats,
        metavar="FORMAT",
        dest="formats",
        help=f"what to write instead, as NAME.FORMAT: one or more of {', '.join(FORMATS)}, with commas or by "
        "giving the flag several times",
    )
    parser.add_argument(
        "-b",
        "--bag",
        type=Path,
        metavar="PATH",
        help="draw the frames of a bag, or of a .yaml file of static transforms, instead of listening",
    )
    options = parser.parse_args(words)
    options.formats = list(dict.fromkeys(chain(*options.formats))) if options.formats else None
    if not options.wait_time >= 0.0:
        parser.error("argument -t/--wait-time: must not be negative")
    options.wait_time = min(options.wait_time, MAX_WAIT_S)
    if options.output and not Path(options.output).parent.is_dir():
        parser.error(f"argument -o/--output: there is no folder {Path(options.output).parent}")
    return options


def _formats(text: str) -> list[str]:
    """Return the formats of a list with commas.

    Raises:
        argparse.ArgumentTypeError: one is unknown.
    """
    formats = text.lower().split(",")
    for ending in formats:
        if ending not in FORMATS:
            raise argparse.ArgumentTypeError(f"{ending!r} is not one of {', '.join(FORMATS)}")
    return formats


def write_files(
    tree: FrameTree, records: list[FrameRecord], formats: Sequence[str], name: str, folder: Path
) -> None:
    """Write a tree's text and pictures, each as NAME.FORMAT.

    Args:
        tree: The tree.
        records: The frames that it was built of, in the order of the buffer, which is that of the text.
        formats: Which files, of FORMATS.
        name: Name of the files, without an ending.
        folder: The folder of the files.

    Raises:
        OSError: a file can't be written.
    """
    for ending in formats:
        write_file(folder / f"{name}.{ending}", _content(tree, records, ending))


def _content(tree: FrameTree, records: list[FrameRecord], file_format: str) -> bytes | str:
    """Return the content of one file; a drawing is imported when it is needed."""
    if file_format == "gv":
        return write_gv(records, tree.recorded_at_s)
    if file_format == "json":
        return json.dumps(tree_json(tree), indent=2, ensure_ascii=False, allow_nan=False) + "\n"
    from tfloom.tf2_tools.drawing.formats import file_content
    from tfloom.tf2_tools.tree_pictures.pictures import draw_page, draw_pages, html_text

    if file_format == "html":
        return html_text(tree, draw_page(tree))
    return file_content(draw_pages(tree) if file_format == "pdf" else [draw_page(tree)], file_format)


def generate_dot(data: Mapping[Any, Mapping[str, Any]], recorded_time: tuple[int, int]) -> str:
    """Return the Graphviz text of the frames that a YAML parser read.

    Args:
        data: The properties of each frame that has a parent, by its id, as `all_frames_as_yaml` names them.
        recorded_time: When the frames were gathered, as whole seconds and nanoseconds since the epoch.

    Raises:
        KeyError: a property is missing.
    """
    records = [
        FrameRecord(
            child=str(child),
            parent=frame["parent"],
            broadcaster=frame["broadcaster"],
            rate=frame["rate"],
            most_recent=frame["most_recent_transform"],
            oldest=frame["oldest_transform"],
            buffer_length=frame["buffer_length"],
        )
        for child, frame in data.items()
    ]
    seconds, nanoseconds = recorded_time
    return write_gv(records, seconds + nanoseconds / 1e9)


def spin_for(node: Node, duration_s: float) -> None:
    """Spin `node` for `duration_s`."""
    end = time.monotonic() + duration_s
    while ok() and (left := end - time.monotonic()) > 0.0:
        spin_once(node, timeout_sec=left)


@contextmanager
def watching(node: Node) -> Iterator[LiveWatch]:
    """Observe who publishes transforms, for the block, by a hidden node on the node's participant."""
    name = NodeName("/", f"_{node.get_name()}_observer")
    participant = node.context.join(name)
    try:
        watch = LiveWatch(participant, name)
        try:
            yield watch
        finally:
            watch.close()
    finally:
        node.context.leave(name)


def publishers_of(observation: Observation) -> dict[str, list[str]]:
    """Return the names of the nodes that publish each child's transform from its present parent, by child."""
    parents = observation.parents()
    names: dict[str, dict[str, None]] = {}
    for edge in observation.edges:
        if parents.get(edge.child) == edge.parent:
            names.setdefault(edge.child, {})[edge.publisher.label] = None
    return {child: list(parents) for child, parents in names.items()}


def publisher_lines(publishers: Mapping[str, Sequence[str]]) -> list[str]:
    """Return a line for each node, with the frames that it publishes."""
    frames: dict[str, list[str]] = {}
    for child, nodes in publishers.items():
        for node in nodes:
            frames.setdefault(node, []).append(child)
    return [f"{node} publishes {', '.join(sorted(children))}" for node, children in sorted(frames.items())]


class Gathered(NamedTuple):
    """What is known of all frames."""

    frames_yaml: str
    """As a buffer's `all_frames_as_yaml` returns it."""
    publishers: dict[str, list[str]]
    """Names of nodes by child; empty if the source has none."""
    at_s: float
    """When it was gathered; of a bag, its end [s since epoch]."""


def listened(node: Node, wait_time_s: float) -> Gathered:
    """Gather the frames that are published within a time [s]."""
    report = node.get_logger()
    with watching(node) as watch:
        buffer = Buffer(node=node)
        listener = TransformListener(buffer, node)
        report.info(f"Listening to tf data for {wait_time_s} seconds...")
        spin_for(node, wait_time_s)
        report.info("Generating graph...")
        frames_yaml = buffer.all_frames_as_yaml()
        publishers = publishers_of(watch.observation())
        listener.unregister()
    return Gathered(frames_yaml, publishers, time.time())


def read(path: Path) -> Gathered:
    """Gather the frames of a bag, or of a file of static transforms.

    Raises:
        BagError, StaticFileError: it is not such a file.
        OSError: it can't be read.
    """
    from tfloom.tf2.buffer import Buffer as PlainBuffer
    from tfloom.tf2_tools.watch.sources import open_path

    buffer = PlainBuffer(None)
    seen = open_path(path, buffer=buffer).observation()
    return Gathered(buffer.all_frames_as_yaml(), {}, seen.taken_ns / 1e9)


def run(node: Node, options: argparse.Namespace) -> int:
    """Collect transforms and write the files; return the exit code."""
    report = node.get_logger()
    if options.bag is None:
        gathered = listened(node, options.wait_time)
    else:
        from tfloom.bag.errors import BagError

        try:
            gathered = read(options.bag)
        except (BagError, StaticFileError) as error:
            report.error(str(error))
            return 1
        except OSError as error:
            report.error(f"can't read {error.filename}: {error.strerror}")
            return 1
    frames_yaml = gathered.frames_yaml
    report.info(f"Result:tf2_msgs.srv.FrameGraph_Response(frame_yaml={frames_yaml!r})")
    # In that line, which is the reference's, every broadcaster is `default_authority`.
    for line in publisher_lines(gathered.publishers):
        report.info(line)
    name = options.output or f"frames_{time.strftime('%Y-%m-%d_%H.%M.%S')}"
    try:
        records = parse_frames_yaml(frames_yaml)
    except ValueError as error:  # a frame id from the wire may have any character
        report.error(f"can't draw these frames: {error}")
        return 1
    if not records:
        report.warning("No tf data received: is anything publishing /tf or /tf_static in this ROS_DOMAIN_ID?")
    tree = build_tree(records, gathered.at_s, gathered.publishers)
    try:
        _export(node, (tree, records), options.formats, name)
    except OSError as error:
        report.error(f"can't write {error.filename}: {error.strerror}")
        return 1
    return 0


def _export(
    node: Node, drawn: tuple[FrameTree, list[FrameRecord]], formats: list[str] | None, name: str
) -> None:
    """Write the files, in the formats that were asked for or those of the reference, and log their names.

    Raises:
        OSError: a file can't be written.
    """
    report, folder = node.get_logger(), Path.cwd()
    for ending in formats or ["pdf"]:
        report.info(f"Exporting graph in {name}.{ending} file...")
    write_files(*drawn, formats or DEFAULT_FORMATS, name, folder)
    picture = folder / f"{name}.pdf"
    if formats is None and picture != folder / COPY_NAME:
        write_file(folder / COPY_NAME, picture.read_bytes())
    if {"html", "pdf", "png", "svg"} & set(formats or DEFAULT_FORMATS):
        from tfloom.tf2_tools.tree_pictures.header import missing_note

        if missing := missing_note(drawn[0]):
            report.warning(missing)


def main(args: list[str] | None = None) -> int:
    """Draw the tree of frames; return the exit code."""
    args = sys.argv[1:] if args is None else args
    options = parse_arguments(remove_ros_args(args))
    return run_program(args, lambda: run(Node("view_frames"), options), if_stopped=1)
