"""What threads that spin, or that the wire calls back on, do when the program ends."""

from __future__ import annotations

import sys

import pytest
from tests.conftest import run_to_end
from tests.zenoh_ports import hold_zenoh_port

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


PUBLISHING = """
import atexit, sys, threading

closed, outcomes = threading.Event(), []

def after_the_context():  # the first one that is registered runs last
    closed.set()
    thread.join()
    if not thread.daemon:
        publish()

atexit.register(after_the_context)
import rclpy
from rclpy.exceptions import RCLError

def publish():
    try:
        publisher.publish(String())
    except RCLError as error:
        print(error)
    finally:
        print("cleaned up")

def work():
    if thread.daemon:
        closed.wait()
        publish()

rclpy.init()
from std_msgs.msg import String
publisher = rclpy.create_node("publishes").create_publisher(String, "chatter", 10)
thread = threading.Thread(target=work, daemon=sys.argv[1] == "daemon")
thread.start()
"""

FLOODING = """
import threading, rclpy
rclpy.init()
from std_msgs.msg import String
publisher = rclpy.create_node("publishes").create_publisher(String, "chatter", 10)
begun = threading.Event()

def flood():
    while True:
        publisher.publish(String(data="x"))
        begun.set()

for _ in range(2):
    threading.Thread(target=flood, daemon=True).start()
begun.wait()
"""


def run(code: str, *arguments: str) -> tuple[int, str, str]:
    command = [sys.executable, "-c", code, *arguments]
    ended = run_to_end(command)
    return ended.returncode, ended.stdout, ended.stderr


@pytest.mark.parametrize("work", ["publishes", "waits"])
@pytest.mark.parametrize("executor", ["SingleThreadedExecutor", "EventsExecutor"])
def test_daemon_thread_that_spins_ends_with_the_program(
    executor: str, work: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    code, _, errors = run(SPINNING, executor, work)
    assert (code, errors) == (0, "")


@pytest.mark.parametrize(
    ("thread", "text"),
    [("daemon", ""), ("main", "Failed to publish: publisher's context is invalid\n")],
)
def test_publishing_after_the_contexts_are_closed(
    thread: str, text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A daemon thread ends, without a traceback, and can be waited for; the main thread gets the exception."""
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    assert run(PUBLISHING, thread) == (0, f"{text}cleaned up\n", "")


@pytest.mark.parametrize("wire", ["rmw_cyclonedds_cpp", "rmw_zenoh_cpp"])
def test_daemon_threads_that_publish_end_with_the_program(
    wire: str, domain_id: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    if wire == "rmw_zenoh_cpp":
        pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")
    monkeypatch.setenv("RMW_IMPLEMENTATION", wire)
    with hold_zenoh_port():
        assert run(FLOODING) == (0, "", "")


def test_callback_on_the_threads_of_the_wire_runs_to_its_end(domain_id: int) -> None:
    """The end of the program closes the wire, which waits for the callback: it must be able to go on."""
    assert run(CALLING_BACK) == (0, "done\n", "")
