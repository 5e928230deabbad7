"""The table of what contradicts between distributions: each row under each of them, and a row of the page."""

from __future__ import annotations

import json
import os
import re
import sys
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import run_to_end

from tfloom.ros_imports import ros_distro
from tfloom.ros_imports.ros_distro import DISTRIBUTIONS, nearest

PAGE = Path(__file__).parents[2] / "docs" / "distributions.md"
SHOW = r"""
import argparse, inspect, json, os, re, sys, warnings
from pathlib import Path
import rclpy
import rosbag2_py
from message_filters import ApproximateTimeSynchronizer, Cache, SimpleFilter
from rclpy.action import ActionServer
from lifecycle_msgs.msg import TransitionEvent
from std_srvs.srv import Empty
from turtlesim.msg import Pose
import turtlesim_msgs.msg
from action_msgs.msg import GoalInfo
from rclpy.action.server import ServerGoalHandle
from rclpy.context import Context
from tfloom.node.action.goal_states import GoalEvent
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings, file_name
from tfloom.cli.bag import play, record
from tfloom.cli.main import COMMANDS
from tfloom.cli.parser import build_parser
from tfloom.cli.shared.picking import values_of_missing
from tfloom.node.values.scalars import parse_value
from tfloom.ros_imports import ros_distro

def outcome(call):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            result = call()
        except Exception as error:
            return type(error).__name__
    return [type(one.message).__name__ for one in caught if one.filename == __file__] or str(result)

class Recorder:
    def __init__(self):
        self.calls = []

    def __getattr__(self, name):
        return lambda *arguments: self.calls.append(name)

def feedback_while_canceling():
    server = Recorder()
    goal = ServerGoalHandle(server, GoalInfo(), None)
    goal.update(GoalEvent.CANCEL_GOAL)
    goal.publish_feedback(None)
    return server.calls

def lacking_a_name():
    try:
        build_parser("ros2", COMMANDS, pick=values_of_missing).parse_args(["topic", "echo"])
    except SystemExit:
        return "usage"

def enter():
    with Context() as context:
        return context.ok()

rclpy.init()
node = rclpy.create_node("asks")
client = node.create_client(Empty, "nobody")
cache = Cache(SimpleFilter(), 1)
filters = [SimpleFilter(), SimpleFilter()]
writer = BagWriter(Path(sys.argv[1]), WriterSettings())
writer.close()
parser = argparse.ArgumentParser()
record.add_arguments(parser)
playing = argparse.ArgumentParser()
play.add_arguments(playing)
begin = Path("/a/rosbag2_2026_05_23-10_00_00")
print(json.dumps({
    "CALL_RAISES_AT_TIMEOUT": outcome(lambda: client.call(Empty.Request(), timeout_sec=0.05)),
    "RESULT_TIMEOUT_S": inspect.signature(ActionServer).parameters["result_timeout"].default,
    "NEEDS_MORE_THAN_A_NAME": outcome(lambda: node.declare_parameter("alone").value),
    "NEEDS_MORE_THAN_A_NAME, several": outcome(lambda: node.declare_parameters("", [("other",)])),
    "CONTEXT_ASKS_FOR_INIT": outcome(enter),
    "FEEDBACK_NEEDS_EXECUTING": feedback_while_canceling(),
    "LOGGER_WARN_IS_DEPRECATED": outcome(lambda: node.get_logger().warn("text")),
    "FOURTH_OF_APPROXIMATE": outcome(lambda: ApproximateTimeSynchronizer(filters, 5, 0.1, True).allow_headerless),
    "FOURTH_OF_APPROXIMATE, fifth": outcome(
        lambda: ApproximateTimeSynchronizer(filters, 5, 0.1, False, True).allow_headerless
    ),
    "HAS_LATER_DEFINITIONS": next(iter(TransitionEvent.get_fields_and_field_types())),
    "TURTLESIM_PACKAGE": Pose._TYPE_NAME,
    "TURTLESIM_PACKAGE, one set": Pose is turtlesim_msgs.msg.Pose,
    "BAG_FILES_HAVE_TIMES": [
        re.sub(r"\d{4}_\d\d_\d\d-\d\d_\d\d_\d\d$", "TIME", file_name(folder, 2)) for folder in (begin, Path("/a/b"))
    ],
    "ALL_RECORDS_ACTIONS": record._options(parser.parse_args(["-a"])).choice.all_actions,
    "LOSSES_HZ": record._options(parser.parse_args(["-a"])).losses_hz,
    "LOSSES_HZ, rosbag2_py": rosbag2_py.RecordOptions().statistics_max_publishing_rate,
    "PLAY_SHOWS_PROGRESS": play._options(playing.parse_args([sys.argv[1]])).progress_hz,
    "NAMES_ARE_OPTIONAL": outcome(lacking_a_name),
    "READS_FLOAT_TAG": repr(parse_value("[!!float 10, !!float 0x10]")),
    "READS_FLOAT_TAG, unknown": outcome(lambda: parse_value("!!foo 10")),
    "REMOVED": outcome(cache.getLastestTime),
    "metadata": writer.info().ros_distro,
    "ROS_DISTRO": os.environ["ROS_DISTRO"],
}))
"""
OUTCOMES: dict[str, tuple[Any, Any, Any]] = {
    "CALL_RAISES_AT_TIMEOUT": ("None", "TimeoutError", "TimeoutError"),
    "RESULT_TIMEOUT_S": (900, 10, 10),
    "NEEDS_MORE_THAN_A_NAME": (["UserWarning"], ["UserWarning"], "TypeError"),
    "NEEDS_MORE_THAN_A_NAME, several": (["UserWarning"], ["UserWarning"], "TypeError"),
    "CONTEXT_ASKS_FOR_INIT": ("True", ["UserWarning"], ["UserWarning"]),
    "FEEDBACK_NEEDS_EXECUTING": (
        ["notify_goal_done", "publish_feedback"],
        ["notify_goal_done", "publish_feedback"],
        ["notify_goal_done", "warn"],
    ),
    "LOGGER_WARN_IS_DEPRECATED": ("True", ["DeprecationWarning"], ["DeprecationWarning"]),
    "FOURTH_OF_APPROXIMATE": ("True", "ValueError", "ValueError"),
    "FOURTH_OF_APPROXIMATE, fifth": ("TypeError", "True", "True"),
    "HAS_LATER_DEFINITIONS": ("timestamp", "timestamp", "stamp"),
    "TURTLESIM_PACKAGE": ("turtlesim/msg/Pose", "turtlesim_msgs/msg/Pose", "turtlesim_msgs/msg/Pose"),
    "TURTLESIM_PACKAGE, one set": (True, True, True),
    "BAG_FILES_HAVE_TIMES": (
        ["rosbag2_2026_05_23-10_00_00_2", "b_2"],
        ["rosbag2_2026_05_23-10_00_00_2", "b_2"],
        ["2_rosbag2_TIME", "2_b_TIME"],
    ),
    "ALL_RECORDS_ACTIONS": (False, True, True),
    "LOSSES_HZ": (0.0, 0.0, 1.0),
    "LOSSES_HZ, rosbag2_py": (0.0, 0.0, 1.0),
    "PLAY_SHOWS_PROGRESS": (0, 3, 3),
    "NAMES_ARE_OPTIONAL": ("usage", "usage", "CommandError"),
    "READS_FLOAT_TAG": ("[10, 16]", "[10, 16]", "[10.0, 16.0]"),
    "READS_FLOAT_TAG, unknown": ("10", "10", "ValueError"),
    "REMOVED": ("None", ["DeprecationWarning"], ["DeprecationWarning"]),
    "metadata": DISTRIBUTIONS,
}
"""What a program sees under each distribution, by the rows of the table."""
GIVEN = {
    **{name: name for name in DISTRIBUTIONS},
    "": "jazzy",
    "humble": "jazzy",
    "noetic": "jazzy",
    "rolling": "lyrical",
    "Lyrcal": "lyrical",
}


@cache
def seen(given: str, folder: Path) -> dict[str, Any]:
    program = folder / "shows.py"
    program.write_text(SHOW)
    environment = {name: value for name, value in os.environ.items() if name != "ROS_DISTRO"}
    environment |= {"RMW_IMPLEMENTATION": "tfloom_local"} | ({"ROS_DISTRO": given} if given else {})
    done = run_to_end([sys.executable, str(program), str(folder / "bag")], env=environment)
    assert done.returncode == 0, done.stderr
    result: dict[str, Any] = json.loads(done.stdout)
    return result


@pytest.mark.parametrize("given", GIVEN)
def test_each_row_is_as_the_distribution_has_it(given: str, tmp_path: Path) -> None:
    outcomes = seen(given, tmp_path)
    assert outcomes.pop("ROS_DISTRO") == (given or "jazzy")
    column = DISTRIBUTIONS.index(GIVEN[given])
    assert outcomes == {row: values[column] for row, values in OUTCOMES.items()}


def test_each_row_is_tested_and_documented() -> None:
    rows = {name for name in vars(ros_distro) if re.fullmatch("[A-Z]+(_[A-Z]+)+", name)} - {
        "ROS_DISTRO",
        "ROS_ENVIRONMENT",
        "TYPE_CHECKING",
    }
    assert {row.partition(",")[0] for row in OUTCOMES} == rows | {"REMOVED", "metadata"}
    documented = set(re.findall(r"^\| `([A-Z_]+)` \|", PAGE.read_text("utf-8"), re.MULTILINE))
    assert documented == rows


def test_each_removed_name_is_documented() -> None:
    text = PAGE.read_text("utf-8")
    for name, (first, successor) in ros_distro.REMOVED.items():
        row = next(line for line in text.splitlines() if line.startswith(f"| {name.replace('`', '')} |"))
        assert first in row.lower(), row
        assert successor.strip("`") in row, row


@pytest.mark.parametrize(
    ("given", "taken"),
    [
        *GIVEN.items(),
        *dict.fromkeys(
            ["ardent", "iron", "melodic", "kinetic", " Jazzy ", "jazz", "?", "9", "ä", "a" * 10**6], "jazzy"
        ).items(),
        *dict.fromkeys(["kilt", "killted", "KILTED", "kz"], "kilted").items(),
        *dict.fromkeys(["makoa", "lyricall", "zzz", "l"], "lyrical").items(),
    ],
)
def test_any_value_takes_the_nearest(given: str, taken: str) -> None:
    assert nearest(given) == taken
