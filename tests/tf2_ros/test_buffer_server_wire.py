"""The program `buffer_server` and its clients, each in a separate process, over the wire."""

from __future__ import annotations

import re
import signal
from collections.abc import Callable

import pytest
from tests.conftest import Program
from tests.tf2_ros.test_wire import BROADCASTER

from tfloom.node.parameters.exceptions import InvalidParameterValueException
from tfloom.rmw.backends import implementation_identifier
from tfloom.tf2_tools.buffer_server import main

SERVER = ("tfloom", "run", "tf2_ros", "buffer_server")
STATIC = ("tfloom", "run", "tf2_ros", "static_transform_publisher")
CLIENT = """
import sys
import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import BufferClient, TransformException

rclpy.init()
node = Node("asker")
client = BufferClient(node, "tf2_buffer_server", timeout_padding=Duration(seconds=15))
print("server", client.wait_for_server(20), flush=True)

def ask(target, source, time, timeout_s):
    try:
        t = client.lookup_transform(target, source, time, Duration(seconds=timeout_s))
        print("x", t.transform.translation.x, "from", t.child_frame_id, flush=True)
    except TransformException as error:
        print(type(error).__name__, error, flush=True)
"""
CROWD = (
    "from concurrent.futures import ThreadPoolExecutor",
    "with ThreadPoolExecutor(10) as pool:",
    "    found = [pool.submit(client.lookup_transform, 'world', 'robot', Time(), Duration(seconds=25))",
    "             for _ in range(10)]",
    "    print('sum', sum(future.result().transform.translation.x for future in found))",
)
"""Queries of many threads at once."""
SOON = "node.get_clock().now() + Duration(seconds=0.3)"


@pytest.fixture
def start(start_program: Callable[..., Program], domain_id: int) -> Callable[..., Program]:
    return start_program


def client(start: Callable[..., Program], *lines: str) -> Program:
    return start("python", "-c", CLIENT + "\n".join(lines))


def test_lookups_waits_and_errors_until_the_server_leaves(start: Callable[..., Program]) -> None:
    server = start(*SERVER)
    asker = client(
        start,
        *CROWD,
        "ask('world', 'camera', Time(), 20)",
        "ask('world', 'robot', Time(), 20)",
        f"ask('camera', 'robot', {SOON}, 20)",
        "ask('world', 'robot', Time(seconds=1), 0)",
        "ask('world', 'nowhere', Time(), 0)",
        "ask('world', 'nowhere', Time(), 0.2)",
        "ask('/world', 'robot', Time(), 0)",
        "now = node.get_clock().now()",
        "t = client.lookup_transform_full('camera', now, 'robot', now, 'world', Duration(seconds=20))",
        "print('full', t.transform.translation.x)",
        "print('can', client.can_transform('world', 'robot', Time()), flush=True)",
        "ask('world', 'nowhere', Time(), 20)",
    )
    crowd = client(start, *CROWD)
    for program in (asker, crowd):
        program.wait_for("server True")
    start("python", "-c", BROADCASTER, "world", "robot")
    start(*STATIC, "--x", "1", "--frame-id", "world", "--child-frame-id", "camera")
    assert crowd.wait() == 0, crowd.output
    assert crowd.lines[-1] == "sum 15.0"
    asker.wait_for("can True")  # another query is waiting
    server.signal(signal.SIGINT)
    assert server.wait() == 0
    assert server.lines == []
    assert asker.wait() == 0, asker.output
    assert asker.lines[:2] == ["server True", "sum 15.0"]
    lines = asker.lines[1:]
    assert lines[1:4] == ["x 1.0 from camera", "x 1.5 from robot", "x 0.5 from robot"]
    assert lines[4].startswith("ExtrapolationException Lookup would require extrapolation into the past.")
    assert lines[5].startswith('LookupException "nowhere" passed to lookupTransform argument source_frame')
    assert lines[6].startswith(
        "TimeoutException Timed out after 0.2 s waiting for the transform from nowhere"
    )
    assert lines[7].startswith('InvalidArgumentException Invalid argument "/world" passed to')
    assert lines[8:-1] == ["full 0.5", "can True"]
    assert re.fullmatch(
        r"TimeoutException The LookupTransform goal sent to the BufferServer did not come back: no response from .*: "
        r"its server left the graph without one\. Something is likely wrong with the server\.",
        lines[-1],
    )


def test_missing_and_killed_server(start: Callable[..., Program]) -> None:
    hasty = CLIENT.replace("wait_for_server(20)", "wait_for_server(0.2)")
    lines = (
        "ask('world', 'robot', Time(), 5)",
        "client = BufferClient(node, 'tf2_buffer_server', timeout_padding=Duration(seconds=5))",
        "client.wait_for_server(20)",
        "ask('world', 'robot', Time(), 0.5)",
        "ask('world', 'robot', Time(), 3)",
    )
    asker = start("python", "-c", hasty + "\n".join(lines))
    asker.wait_for("not ready")
    assert asker.lines == ["server False", "TimeoutException The BufferServer is not ready."]
    server = start(*SERVER)
    asker.wait_for("TimeoutException Timed out after 0.5 s")  # a second query is waiting
    server.signal(signal.SIGKILL)
    assert asker.wait() == 0, asker.output
    why = " in the specified time"
    if implementation_identifier() == "rmw_zenoh_cpp":  # which reports its end at once
        why = r": no response from /tf2_buffer_server/_action/\w+: its server left the graph without one"
    assert re.fullmatch(
        rf"TimeoutException The LookupTransform goal sent to the BufferServer did not come back{why}\. "
        r"Something is likely wrong with the server\.",
        asker.lines[-1],
    ), asker.output


def test_invalid_buffer_size_is_rejected(start: Callable[..., Program]) -> None:
    server = start(*SERVER, "--ros-args", "-p", "buffer_size:=abc")
    assert server.wait() == 1
    assert server.lines[0].startswith(
        "buffer_server: Trying to set parameter 'buffer_size' to 'abc' of type 'STRING'"
    )
    assert len(server.lines) == 2  # the last line reports that the program failed


@pytest.mark.parametrize(("size", "value"), [("-1.0", "-1.0"), (".inf", "inf"), ("1.0e+10", "10000000000.0")])
def test_size_that_is_no_duration_is_an_error(size: str, value: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    with pytest.raises(InvalidParameterValueException) as raised:
        main(["--ros-args", "-p", f"buffer_size:={size}"])
    assert str(raised.value).startswith(f"Invalid parameter value ({value}) for parameter. Reason: must be a")


def test_unknown_arguments_are_rejected(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="2"):
        main(["tf2_buffer_server"])
    assert "buffer_server: error: unrecognized arguments: tf2_buffer_server\n" in capsys.readouterr().err
