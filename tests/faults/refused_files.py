"""Do what a row names, while all changes of its folder are refused from one call on: the first, the second, … in turn.

Run with `refused_writes.c` preloaded: `python -m tests.faults.refused_files ROW FOLDER`. Prints a line for each place
where the refusals began: how many there were, what was raised, and what was told.
"""

from __future__ import annotations

import ctypes
import errno
import io
import json
import os
import sys
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from types import SimpleNamespace

ERRORS = (errno.ENOSPC, errno.EACCES, errno.EROFS, errno.EIO)
MAX_CALLS = 60


def log_of_a_node(folder: Path) -> None:
    """Log, shut down and log again, as a program does that has two lives."""
    from tfloom.node import client_library as rclpy
    from tfloom.node.node import Node

    for life in ("first", "second"):
        os.environ.update(ROS_LOG_DIR=str(folder / life), RMW_IMPLEMENTATION="tfloom_local")
        rclpy.init(args=[])
        node = Node("under_test")
        for number in range(3):
            node.get_logger().info(f"line {number}")
        node.destroy_node()
        rclpy.shutdown()


def log_of_a_launch(folder: Path) -> None:
    """Launch a process whose lines go to the screen, the launch's log and its own."""
    from tfloom.launch.actions.execute_process import ExecuteProcess
    from tfloom.launch.entities.launch_description import LaunchDescription
    from tfloom.launch.launch_service import LaunchService
    from tfloom.launch.logs import logging

    os.environ["ROS_LOG_DIR"] = str(folder / "log")
    process = ExecuteProcess(cmd=["echo", "on the screen"], output="full")
    service = LaunchService()
    service.include_launch_description(LaunchDescription([process]))
    logging.log_launch_config(logger=logging.get_logger("launch"))
    if code := service.run():
        raise RuntimeError(f"the launch ended with {code}")
    logging.reset()


def picture_of_a_simulation(folder: Path) -> None:
    """Record pictures, of which one is written meanwhile."""
    from PIL import Image

    from tfloom.turtlesim.record import FRAME_MS, SIDE_PX, STILL_MS, RecordingError, open_recorder

    recorder = open_recorder(folder / "picture.png")
    picture = Image.new("RGB", (SIDE_PX, SIDE_PX))
    for _ in range(STILL_MS // FRAME_MS + 1):
        recorder.add(lambda: picture)
    try:
        recorder.finish()
    except RecordingError as error:
        print(f"told: {error}", file=sys.stderr)


def layout_of_a_page(folder: Path) -> None:
    """Save the layout of a page where the program was told to, in place of a former one."""
    from tfloom.viewer import program
    from tfloom.viewer.page_command import PageError

    path = folder / "layout.yaml"
    told: list[object] = []
    viewer = SimpleNamespace(
        view=SimpleNamespace(layout=lambda _: None),
        _scenes=SimpleNamespace(saved_view=lambda _: None),
        layout_path=path,
        pages=SimpleNamespace(answer=lambda _, said: told.append(said)),
    )
    program.layout_text = lambda _: "the layout"
    try:
        program.Viewer._save_layout(viewer, "page", for_rviz=False)
    except PageError as error:
        print(f"told: {error}", file=sys.stderr)
        if path.read_text("utf-8") != "former":
            raise
    if told and path.read_text("utf-8") != "the layout":
        raise RuntimeError("the layout is said to be saved, and is not")


ROWS: dict[str, Callable[[Path], None]] = {
    function.__name__: function
    for function in (log_of_a_node, log_of_a_launch, picture_of_a_simulation, layout_of_a_page)
}


def prepare(folder: Path) -> None:
    """Create a folder in which the file of each row may replace a former one."""
    folder.mkdir()
    (folder / "layout.yaml").write_text("former", "utf-8")


def main(row: str, folder: Path) -> None:
    control = ctypes.CDLL(None)
    for allowed in range(MAX_CALLS):
        place = folder / str(allowed)
        prepare(place)
        raised, output = "", io.StringIO()
        with redirect_stderr(output), redirect_stdout(io.StringIO()):
            control.refuse_writes(str(place).encode(), allowed, ERRORS[allowed % len(ERRORS)])
            try:
                ROWS[row](place)
            except Exception as error:  # noqa: BLE001  # told to the test
                raised = f"{type(error).__name__}: {error}"
            refused = control.refused_writes()
            control.refuse_writes(b"", 0, 0)
        told = [line for line in output.getvalue().splitlines() if line]
        print(json.dumps({"refused": refused, "raised": raised, "told": told}), flush=True)
        if not refused:
            return


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
