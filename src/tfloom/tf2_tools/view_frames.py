"""view_frames: listen to all transforms for a while, then write the tree as a Graphviz file and as a PDF."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from tfloom.node.client_library import spin_once
from tfloom.node.context.utilities import ok, remove_ros_args
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener
from tfloom.tf2_tools.frame_records import FrameRecord, parse_frames_yaml, write_gv
from tfloom.whole_files import write_file

COPY_NAME = "frames.pdf"
"""The name of the file in tutorials."""


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
    options = parser.parse_args(words)
    if not options.wait_time >= 0.0:
        parser.error("argument -t/--wait-time: must not be negative")
    if options.output and not Path(options.output).parent.is_dir():
        parser.error(f"argument -o/--output: there is no folder {Path(options.output).parent}")
    return options


def write_files(frames_yaml: str, name: str, recorded_at: float, folder: Path) -> list[Path]:
    """Write a tree's text and picture.

    Args:
        frames_yaml: The frames, as a buffer's `all_frames_as_yaml` returns them.
        name: Name of the files, without an ending.
        recorded_at: Time of the recording [s since epoch].
        folder: The folder of the files.

    Returns:
        The files: NAME.gv, NAME.pdf, and the picture's copy unless it has that name.

    Raises:
        OSError: a file can't be written.
    """
    from tfloom.tf2_tools.frame_drawing import draw_frames

    records = parse_frames_yaml(frames_yaml)
    text, picture, copy = folder / f"{name}.gv", folder / f"{name}.pdf", folder / COPY_NAME
    write_file(text, write_gv(records, recorded_at))
    draw_frames(records, recorded_at, picture)
    if picture == copy:
        return [text, picture]
    write_file(copy, picture.read_bytes())
    return [text, picture, copy]


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


def run(node: Node, options: argparse.Namespace) -> int:
    """Collect transforms and write the files; return the exit code."""
    buffer = Buffer(node=node)
    listener = TransformListener(buffer, node)
    node.get_logger().info(f"Listening to tf data for {options.wait_time} seconds...")
    spin_for(node, options.wait_time)
    node.get_logger().info("Generating graph...")
    frames_yaml = buffer.all_frames_as_yaml()
    node.get_logger().info(f"Result:tf2_msgs.srv.FrameGraph_Response(frame_yaml={frames_yaml!r})")
    listener.unregister()
    name = options.output or f"frames_{time.strftime('%Y-%m-%d_%H.%M.%S')}"
    try:
        records = parse_frames_yaml(frames_yaml)
    except ValueError as error:  # a frame id from the wire may have any character
        node.get_logger().error(f"can't draw these frames: {error}")
        return 1
    if not records:
        node.get_logger().warning(
            "No tf data received: is anything publishing /tf or /tf_static in this ROS_DOMAIN_ID?"
        )
    node.get_logger().info(f"Exporting graph in {name}.pdf file...")
    try:
        write_files(frames_yaml, name, time.time(), Path.cwd())
    except OSError as error:
        node.get_logger().error(f"can't write {error.filename}: {error.strerror}")
        return 1
    return 0


def main(args: list[str] | None = None) -> int:
    """Draw the tree of frames; return the exit code."""
    args = sys.argv[1:] if args is None else args
    options = parse_arguments(remove_ros_args(args))
    return run_program(args, lambda: run(Node("view_frames"), options), if_stopped=1)
