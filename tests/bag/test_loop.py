"""A bag played in a loop with --clock: the frames of nodes with simulated time are cleared once a loop."""

from __future__ import annotations

import re
import time
from collections import Counter
from itertools import pairwise
from pathlib import Path

import pytest
from tests.bag.written_bags import START_NS, topic

from tfloom.bag import open_bag
from tfloom.bag.playing.play_options import PlayOptions
from tfloom.bag.playing.player import Player
from tfloom.bag.writing.bag_writer import BagWriter
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.values.time import Time
from tfloom.rosidl import cdr
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener

LENGTH_S = 20
PERIOD_NS = 50_000_000
RATE = 40.0
LOOPS = 4


def write_moving_frames(folder: Path) -> None:
    writer = BagWriter(folder)
    channel = writer.add_topic(topic("/tf", "tf2_msgs/msg/TFMessage"))
    for number in range(LENGTH_S * 10**9 // PERIOD_NS):
        stamp_ns = START_NS + number * PERIOD_NS
        moving = [TransformStamped(child_frame_id=child) for child in ("base", "laser")]
        for stamped, parent in zip(moving, ("map", "base"), strict=True):
            stamped.header.frame_id = parent
            stamped.header.stamp = Time(nanoseconds=stamp_ns).to_msg()
            stamped.transform.rotation.w = 1.0
        writer.push(channel, cdr.encode(TFMessage(transforms=moving)), stamp_ns, stamp_ns)
    writer.close()


def test_frames_are_cleared_once_a_loop(
    local_context: Context, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    write_moving_frames(tmp_path / "bag")
    node = Node(
        "listener", context=local_context, parameter_overrides=[Parameter("use_sim_time", value=True)]
    )
    buffer = Buffer(node=node)
    TransformListener(buffer, node)
    known = 0
    start = time.monotonic()
    with open_bag(tmp_path / "bag") as bag, SingleThreadedExecutor(context=local_context) as executor:
        executor.add_node(node)
        options = PlayOptions(rate=RATE, is_loop=True, clock_hz=200.0, has_keyboard=False)
        player = Player(bag, options, context=local_context)
        player.start()
        stamps: list[int] = []
        while time.monotonic() - start < 20.0:
            executor.spin_once(0.02)
            if buffer.can_transform("map", "laser", Time()):
                known += 1
                stamp = buffer.lookup_transform("map", "laser", Time()).header.stamp
                stamps.append(stamp.sec)
                if sum(later < earlier for earlier, later in pairwise(stamps)) == LOOPS:
                    break
        player.stop()
        player.destroy_node()
    said = capfd.readouterr().err
    assert said.count("Detected jump back in time. Clearing tf buffer.") == LOOPS
    assert known > 20 * LOOPS
    old = Counter(re.findall(r"TF_OLD_DATA ignoring data from the past for frame (\w+)", said))
    most = int(time.monotonic() - start) + 1
    assert all(count <= most for count in old.values()), said
