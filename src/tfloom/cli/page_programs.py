"""The programs of other packages for which the page of `tfloom view` stands in: rviz2, joint_state_publisher_gui."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from tfloom.cli import view
from tfloom.common.terminal import report
from tfloom.node.context.arguments import parse_arguments
from tfloom.node.context.utilities import remove_ros_args
from tfloom.tf2_tools.watch.model import STATIC_TOPIC, TF_TOPIC
from tfloom.viewer.extra import MISSING, is_installed

__all__ = ["run_joint_state_publisher_gui", "run_rviz2"]

RVIZ2 = "rviz2"


def run_rviz2(args: list[str] | None = None) -> int:
    """Run `ros2 run rviz2 rviz2`: serve the page of `tfloom view` until Ctrl-C; return the exit code.

    The time and remapped topics of transforms are taken from ROS arguments.
    """
    parsed = parse_arguments(sys.argv[1:] if args is None else args)
    parser = argparse.ArgumentParser(
        prog=RVIZ2, description="Show the page of `tfloom view` in place of RViz."
    )
    parser.add_argument(
        "-d", "--display-config", metavar="FILE", type=Path, help="a file of RViz, or of ours"
    )
    parser.add_argument(
        "-f", "--fixed-frame", metavar="FRAME", default="", help="the frame that stands still"
    )
    for flags, text in (
        (("-t", "--display-title-format"), "a title"),
        (("-s", "--splash-screen"), "a picture"),
    ):
        parser.add_argument(*flags, help=f"{text}, which the page has none of: it has no effect")
    parser.add_argument(
        "--fullscreen", action="store_true", help="it has no effect: a browser does it by F11"
    )
    parser.add_argument("-l", "--ogre-log", action="store_true", help="it has no effect")
    words = parser.parse_args(parsed.rest)
    if not is_installed():
        report(f"{RVIZ2}: {MISSING.format(name='the page that stands in for RViz')}")
        return 1
    name = parsed.node_name(RVIZ2)
    namespace = parsed.namespace(name, "/")
    full = f"{namespace.rstrip('/')}/{name}"
    asked = ["--fixed-frame", words.fixed_frame]
    for option, topic in (("--tf-topic", TF_TOPIC), ("--tf-static-topic", STATIC_TOPIC)):
        asked += [option, parsed.remap(topic, name, namespace) or topic]
    if words.display_config is not None:
        asked += ["--config", str(words.display_config)]
    if parsed.parameter_overrides(full).get("use_sim_time") is True:
        asked.append("--use-sim-time")
    what = "a new view" if words.display_config is None else str(words.display_config)
    print(f"{RVIZ2}: the page of `tfloom view` stands in for RViz, and shows {what}", flush=True)
    return view.serve_as(RVIZ2, asked)


JOINT_STATE_PUBLISHER_GUI = "joint_state_publisher_gui"


def run_joint_state_publisher_gui(args: list[str] | None = None) -> int:
    """Publish the states of joints, and serve the page on which they are moved, until Ctrl-C; return the exit code.

    ROS arguments are those of the node joint_state_publisher.
    """
    words = sys.argv[1:] if args is None else args
    parser = argparse.ArgumentParser(
        prog=JOINT_STATE_PUBLISHER_GUI,
        description="Publish the states of a robot's joints, moved by sliders on the page of `tfloom view`.",
    )
    parser.add_argument("urdf_file", nargs="?", help="URDF file to use")
    urdf_file = parser.parse_args(remove_ros_args(words)).urdf_file
    if not is_installed():
        report(f"{JOINT_STATE_PUBLISHER_GUI}: {MISSING.format(name='the page with sliders')}")
        return 1
    print(f"{JOINT_STATE_PUBLISHER_GUI}: sliders are on the page of `tfloom view`", flush=True)
    return view.serve_as(JOINT_STATE_PUBLISHER_GUI, [], view.Publishing(urdf_file, list(words)))
