"""Nodes in two processes, on a real wire."""

from __future__ import annotations

import signal
from collections.abc import Callable
from typing import Any

import pytest
from tests.conftest import Program, wait_until

from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.context.context import Context
from tfloom.node.executing.event_handler import SubscriptionEventCallbacks
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import QoSProfile
from tfloom.node.values.duration import Duration

SERVER = """
import rclpy
from example_interfaces.srv import AddTwoInts
from std_msgs.msg import String

def add(request, response):
    response.sum = request.a + request.b
    return response

rclpy.init()
node = rclpy.create_node("server", namespace="/there")
publisher = node.create_publisher(String, "/chatter", 10)
node.create_timer(0.05, lambda: publisher.publish(String(data="hello")))
node.create_service(AddTwoInts, "/add", add)
print("serving", flush=True)
try:
    rclpy.spin(node)
except rclpy.executors.ExternalShutdownException:
    node.destroy_node()
"""


def test_topics_services_and_names_work_between_processes(
    domain_id: int, monkeypatch: pytest.MonkeyPatch, start_program: Callable[..., Program]
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_cyclonedds_cpp")
    program = start_program("python", "-c", SERVER)
    heard: list[str] = []
    with Context() as context, Node("here", context=context) as node:
        executor = SingleThreadedExecutor(context=context)
        executor.add_node(node)
        node.create_subscription(String, "chatter", lambda msg: heard.append(msg.data), 10)
        client = node.create_client(AddTwoInts, "add")
        assert client.wait_for_service(timeout_sec=20)
        future = client.call_async(AddTwoInts.Request(a=40, b=2))
        executor.spin_until_future_complete(future, timeout_sec=20)
        assert future.result().sum == 42
        for _ in range(1000):
            if heard:
                break
            executor.spin_once(timeout_sec=0.1)
        assert heard[0] == "hello"
        assert node.wait_for_node("/there/server", timeout=20)
        (info,) = node.get_publishers_info_by_topic("/chatter")
        assert (info.node_namespace, info.node_name) == ("/there", "server")
        program.signal(signal.SIGTERM)
        assert program.wait() == 0, program.output
        for _ in range(1000):
            if not client.service_is_ready():
                break
            executor.spin_once(timeout_sec=0.01)
        assert not client.service_is_ready()


def test_missed_deadline_calls_the_callbacks(domain_id: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_cyclonedds_cpp")
    statuses: list[Any] = []
    with Context() as context, Node("here", context=context) as node:
        executor = SingleThreadedExecutor(context=context)
        executor.add_node(node)
        qos = QoSProfile(depth=10, deadline=Duration(seconds=0.02))
        publisher = node.create_publisher(String, "chatter", qos)
        callbacks = SubscriptionEventCallbacks(deadline=statuses.append)
        node.create_subscription(String, "chatter", lambda msg: None, qos, event_callbacks=callbacks)
        wait_until(publisher.get_subscription_count)
        publisher.publish(String())
        for _ in range(200):
            if statuses:
                break
            executor.spin_once(timeout_sec=0.1)
        assert statuses[0].total_count >= 1
