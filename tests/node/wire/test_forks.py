"""Forked processes: what a child inherited raises errors, it ends quietly, and it may start anew."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable

import pytest
from tests.zenoh_ports import NEEDS_ZENOH

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")

PARENT = """
import os, signal, sys, time
import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String
rclpy.init(args=[])
node = Node("parent")
publisher = node.create_publisher(String, "chatter", 10)
heard = []
node.create_subscription(String, "chatter", lambda message: heard.append(message.data), 10)
client = node.create_client(AddTwoInts, "add")
rate = node.create_rate(10.0)
executor = SingleThreadedExecutor()
executor.add_node(node)

def hear(text):
    end_s = time.monotonic() + 20
    while text not in heard and time.monotonic() < end_s:
        publisher.publish(String(data="parent"))
        executor.spin_once(timeout_sec=0.05)
    return text in heard

hear("parent")

def join(child):
    _, status = os.waitpid(child, 0)
    print("child", os.waitstatus_to_exitcode(status), flush=True)
    heard.clear()
    print("parent", hear("parent"), flush=True)
"""

OPERATIONS = """
operations = {
    "publish": lambda: publisher.publish(String(data="child")),
    "count subscriptions": publisher.get_subscription_count,
    "wait for acknowledgements": publisher.wait_for_all_acked,
    "assert liveliness": publisher.assert_liveliness,
    "call": lambda: client.call_async(AddTwoInts.Request()),
    "call and wait": lambda: client.call(AddTwoInts.Request()),
    "find a server": client.service_is_ready,
    "wait for a server": client.wait_for_service,
    "create a publisher": lambda: node.create_publisher(String, "other", 1),
    "create a subscription": lambda: node.create_subscription(String, "other", print, 1),
    "create a timer": lambda: node.create_timer(1.0, print),
    "sleep": rate.sleep,
    "look at the graph": node.get_topic_names_and_types,
    "count publishers": lambda: node.count_publishers("chatter"),
    "spin": executor.spin,
    "spin once": lambda: executor.spin_once(timeout_sec=0.1),
    "spin the node": lambda: rclpy.spin_once(node, timeout_sec=0.1),
    "create a node": lambda: Node("child", context=node.context),
}
child = os.fork()
if child == 0:
    for name, operate in operations.items():
        try:
            print(name, operate(), flush=True)
        except Exception as error:
            has_advice = all(part in str(error) for part in ADVICE)
            print(name, type(error).__name__ if has_advice else error, flush=True)
    sys.exit(3)
join(child)
"""
QUIET = ("-W", "ignore::DeprecationWarning")  # From 3.12 on Python warns about a fork with other threads.


ADVICE = {
    "rmw_cyclonedds_cpp": "rclpy.init() and create the node anew",
    "rmw_zenoh_cpp": "'forkserver', or fork before the first node is created",
}


def test_every_operation_on_what_was_inherited_raises(
    domain_id: int, local_wire: str, start_program: Callable
) -> None:
    advice = ["'spawn'", ADVICE[local_wire]]
    program = start_program("python", *QUIET, "-c", f"ADVICE = {advice}\n{PARENT}{OPERATIONS}")
    assert program.wait() == 0
    *children, child, parent = program.lines
    assert (child, parent) == ("child 3", "parent True")
    assert len(children) == 18
    assert {line.split(" ")[-1] for line in children} == {"ForkedProcessError", "ForkedError"}, program.output


ENDS = {
    "os._exit(3)": 3,
    "sys.exit(3)": 3,
    "node.destroy_node(); executor.shutdown(); sys.exit(4)": 4,
    "del node, publisher, client, executor; import gc; gc.collect(); sys.exit(5)": 5,
    "node.destroy_node(); rclpy.shutdown(); sys.exit(7)": 7,
    "node.context.destroy(); rclpy.try_shutdown(); sys.exit(6)": 6,
    "os.kill(os.getpid(), signal.SIGTERM); time.sleep(60)": -signal.SIGTERM,
}
"""How a child ends, and its exit code."""

FORKS = """
for end in ENDS:
    child = os.fork()
    if not child:
        exec(end)
    join(child)

import multiprocessing
for seconds in (0, 60):
    process = multiprocessing.get_context("fork").Process(target=time.sleep, args=(seconds,))
    process.start()
    if seconds:
        process.terminate()
    process.join()
    print("child", process.exitcode)
    heard.clear()
    print("parent", hear("parent"))
"""


def test_children_end_quietly_without_effect_on_their_parent(domain_id: int, start_program: Callable) -> None:
    program = start_program("python", *QUIET, "-c", f"ENDS = {list(ENDS)}\n{PARENT}{FORKS}")
    assert program.wait() == 0
    codes = [*ENDS.values(), 0, -signal.SIGTERM]
    assert program.lines == [line for code in codes for line in (f"child {code}", "parent True")]


CHILD = """
def run_child():
    rclpy.init(args=[])
    other = Node("child")
    sender = other.create_publisher(String, "chatter", 10)
    while not sender.get_subscription_count():
        time.sleep(0.01)
    sender.publish(String(data="from the child"))
    sender.wait_for_all_acked()
    other.destroy_node()
    rclpy.shutdown()
    sys.exit(0)
"""


def test_a_child_and_a_grandchild_may_start_anew(domain_id: int, start_program: Callable) -> None:
    program = """
child = os.fork()
if not child:
    run_child()
print("heard", hear("from the child"), flush=True)
join(child)

child = os.fork()
if not child:
    rclpy.init(args=[])
    between = Node("between")
    grandchild = os.fork()
    if not grandchild:
        run_child()
    _, status = os.waitpid(grandchild, 0)
    rclpy.shutdown()
    sys.exit(os.waitstatus_to_exitcode(status))
print("heard", hear("from the child"), flush=True)
join(child)
"""
    program = start_program("python", *QUIET, "-c", PARENT + CHILD + program)
    assert program.wait() == 0
    assert program.lines == 2 * ["heard True", "child 0", "parent True"]


INITIALISE = """
child = os.fork()
if not child:
    try:
        rclpy.init(args=[])
    except RuntimeError as error:
        print(type(error).__name__, "'forkserver'" in str(error), flush=True)
    sys.exit(3)
join(child)
"""


@pytest.mark.parametrize("local_wire", [pytest.param("rmw_zenoh_cpp", marks=NEEDS_ZENOH)], indirect=True)
def test_on_zenoh_a_child_may_not_start_anew(domain_id: int, start_program: Callable) -> None:
    program = start_program("python", *QUIET, "-c", PARENT + INITIALISE)
    assert program.wait() == 0
    assert program.lines == ["ForkedError True", "child 3", "parent True"]


@pytest.mark.parametrize("first", ["", "rclpy.init(args=[])"], ids=["imported", "initialised"])
def test_a_child_of_a_process_without_nodes_has_all(
    first: str, domain_id: int, start_program: Callable
) -> None:
    program = f"""
import os, sys, time
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
{first}
child = os.fork()
if not rclpy.ok():
    rclpy.init(args=[])
node = Node("child" if child == 0 else "parent")
heard, satisfied = [], set()
def hear(message):
    name, _, has_all = message.data.partition(" ")
    heard.append(name)
    satisfied.update([name] if has_all else [])
node.create_subscription(String, "chatter", hear, 10)
publisher = node.create_publisher(String, "chatter", 10)
def say():
    publisher.publish(String(data=node.get_name() + (" has all" if len(set(heard)) == 2 else "")))
node.create_timer(0.05, say)  # no faster, or the last message of the other would be lost from a queue of ten
while len(satisfied) < 2:  # until the other has heard this one, too: discovery may take longer in one direction
    rclpy.spin_once(node)
publisher.wait_for_all_acked()
rclpy.shutdown()
if not child:
    sys.exit(0)
print(sorted(set(heard)), os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""
    program = start_program("python", *QUIET, "-c", program)
    assert program.wait() == 0
    assert program.lines == ["['child', 'parent'] 0"]
