"""What threads that spin, or that the wire calls back on, do when the program ends."""

from __future__ import annotations

import subprocess
import sys

import pytest

SPINNING = """
import atexit, sys, threading

in_callback, closed = threading.Event(), threading.Event()

def after_the_context():  # the first one that is registered runs last
    closed.set()
    spin.join(0.5)

atexit.register(after_the_context)
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.experimental import EventsExecutor

def work():
    in_callback.set()
    closed.wait()
    if sys.argv[2] == "publishes":
        publisher.publish(String())

rclpy.init()
from std_msgs.msg import String
node = rclpy.create_node("spins")
publisher = node.create_publisher(String, "chatter", 10)
node.create_timer(0.001, work)
executor = globals()[sys.argv[1]]()
executor.add_node(node)
spin = threading.Thread(target=executor.spin, daemon=True)
spin.start()
in_callback.wait()
"""

CALLING_BACK = """
import sys, threading, time
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.time import Time
from tf2_ros import Buffer, TransformBroadcaster, TransformListener

rclpy.init()
node = rclpy.create_node("calls_back")
buffer = Buffer()
listener = TransformListener(buffer, node)
broadcaster = TransformBroadcaster(node)
begun = threading.Event()

def notice(_):
    begun.set()
    time.sleep(1.3)  # longer than the interpreter's end waits
    buffer.all_frames_as_yaml()  # releases the GIL, and acquires it again
    print("done", flush=True)

buffer.wait_for_transform_async("map", "base", Time(seconds=1)).add_done_callback(notice)
message = TransformStamped(child_frame_id="base")
message.header.frame_id, message.header.stamp.sec, message.transform.rotation.w = "map", 1, 1.0
while not begun.wait(0.05):
    broadcaster.sendTransform(message)
"""


def run(code: str, *arguments: str) -> tuple[int, str, str]:
    command = [sys.executable, "-c", code, *arguments]
    ended = subprocess.run(command, check=False, capture_output=True, text=True, timeout=60)
    return ended.returncode, ended.stdout, ended.stderr


@pytest.mark.parametrize("work", ["publishes", "waits"])
@pytest.mark.parametrize("executor", ["SingleThreadedExecutor", "EventsExecutor"])
def test_daemon_thread_that_spins_ends_with_the_program(
    executor: str, work: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    code, _, errors = run(SPINNING, executor, work)
    assert (code, errors) == (0, "")


def test_callback_on_the_threads_of_the_wire_runs_to_its_end(domain_id: int) -> None:
    """The end of the program closes the wire, which waits for the callback: it must be able to go on."""
    assert run(CALLING_BACK) == (0, "done\n", "")
