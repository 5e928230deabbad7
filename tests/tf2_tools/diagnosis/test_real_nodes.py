"""`tfloom tf doctor` beside what users run: programs of tf2, a buffer server, a simulation."""

from __future__ import annotations

import json
import signal
from collections.abc import Callable
from typing import Any

import pytest

from tfloom.cli.quiet_imports import INTERRUPTED
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName
from tfloom.rmw.qos import QoS
from tfloom.rmw.typed_names import topic_of

STATIC = ("tfloom", "run", "tf2_ros", "static_transform_publisher")
SPINNING = "Spinning until stopped"
ASKER = """
import time, rclpy
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import BufferClient, TransformException

rclpy.init()
client = BufferClient(Node("asker"), "tf2_buffer_server")
print("server", client.wait_for_server(20), flush=True)
while True:
    try:
        client.lookup_transform("world", "camra", Time())
    except TransformException:
        time.sleep(0.05)
"""
SIMULATION = """
import sys, time, rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from rosgraph_msgs.msg import Clock
from tf2_ros import TransformBroadcaster

rclpy.init()
simulator, stray = Node("simulator"), Node("stray")
clock = simulator.create_publisher(Clock, "/clock", 10)
start = time.time()
while True:
    now = int((100.0 + time.time() - start) * 1e9)
    message = Clock()
    message.clock.sec, message.clock.nanosec = divmod(now, 10**9)
    clock.publish(message)
    for node, child, stamp in ((simulator, "base", now), (stray, "arm", time.time_ns())):
        if not hasattr(node, "broadcaster"):
            node.broadcaster = TransformBroadcaster(node)
        t = TransformStamped(child_frame_id=child)
        t.header.frame_id = "world"
        t.header.stamp.sec, t.header.stamp.nanosec = divmod(stamp, 10**9)
        t.transform.translation.x = (stamp % 10**9) / 1e12
        node.broadcaster.sendTransform(t)
    print("published", flush=True)
    time.sleep(0.02)
"""


def report_of(start: Callable[..., Any], *words: str) -> dict[str, Any]:
    program = start("tfloom", "tf", "doctor", "--json", *words)
    program.wait()
    report: dict[str, Any] = json.loads(program.output)
    return report


def start_buffer_server(start: Callable[..., Any]) -> None:
    """Start a publisher, a buffer server, and a client that asks it for a frame that isn't there."""
    start(*STATIC, "--x", "1", "--frame-id", "world", "--child-frame-id", "camera").wait_for(SPINNING)
    start("tfloom", "run", "tf2_ros", "buffer_server")
    start("python", "-c", ASKER).wait_for("server True")


def found(report: dict[str, Any]) -> list[tuple[str, list[str]]]:
    return [(finding["code"], finding["nodes"]) for finding in report["findings"]]


def test_a_program_that_runs_twice(domain_id: int, start_program: Callable[..., Any]) -> None:
    mounting = ("--frame-id", "world", "--child-frame-id", "camera", "--ros-args", "-r", "__node:=mounting")
    for program in [start_program(*STATIC, "--x", "1", *mounting) for _ in range(2)]:
        program.wait_for(SPINNING)
    report = report_of(start_program, "--seconds", "0.4")
    assert found(report) == [("TF101", ["/mounting"])]
    gids = {source["gid"][:24] for source in report["findings"][0]["sources"]}
    assert len(gids) == 2, "two participants"


def test_requests_to_a_buffer_server(domain_id: int, start_program: Callable[..., Any]) -> None:
    start_buffer_server(start_program)
    report = report_of(start_program, "--seconds", "0.8")
    assert found(report) == [("TF602", ["/asker"])]
    finding = report["findings"][0]
    assert finding["frames"] == ["camra"]
    assert finding["evidence"][0]["text"].endswith("did you mean camera?")
    assert finding["sources"][0]["topic"] == "/tf2_buffer_server"


def test_a_buffer_server_on_zenoh_is_no_fault(
    domain_id: int, start_program: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """There, a client's question reaches the servers alone, so the doctor can't read it."""
    pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    start_buffer_server(start_program)
    assert found(report_of(start_program, "--seconds", "0.8")) == []


def test_stamps_are_compared_with_the_simulated_time(
    domain_id: int, start_program: Callable[..., Any]
) -> None:
    start_program("python", "-c", SIMULATION).wait_for("published")
    report = report_of(start_program, "--seconds", "0.8", "--max-gap", "1")
    assert found(report) == [("TF402", ["/stray"]), ("TF403", ["/stray"])]
    assert report["is_simulated"] is True


def test_ctrl_c_ends_listening_with_a_report(
    domain_id: int, start_program: Callable[..., Any], wait_until: Callable[..., None]
) -> None:
    observer = open_participant()
    try:
        node = NodeName("/", "elsewhere")
        observer.create_writer(node, topic_of(TFMessage, "/robot1/tf"), QoS())

        def is_read() -> bool:
            return any(end.topic.name == "/tf_static" for end in observer.graph.endpoints())

        for _ in range(5):
            program = start_program("tfloom", "tf", "doctor", "--seconds", "600")
            wait_until(is_read, what="its readers")
            program.signal(signal.SIGINT)
            if (code := program.wait()) != INTERRUPTED:
                break
            # On a busy machine, the signal came after it had opened its readers, and before it listened.
            wait_until(lambda: not is_read(), what="the end of its readers")
        assert code == 1
        assert "TF108 error: no transform came within" in program.output
        assert "transforms are on /robot1/tf: try `--tf-topic /robot1/tf`" in program.output
    finally:
        observer.close()
