"""turtlesim's interfaces have the package name of the distribution, and a user of the other name is told so."""

from __future__ import annotations

import os
import runpy
import sys
from typing import Any

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.turtlesim.srv import Spawn
from tfloom.interfaces.turtlesim_msgs.srv import Spawn as SpawnSinceKilted
from tfloom.node import turtlesim_types
from tfloom.node.endpoints import client as clients
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.ros_imports import ros_distro

SERVED = "/spawn is served as turtlesim_msgs/srv/Spawn, not as turtlesim/srv/Spawn: turtlesim's types are in"


@pytest.mark.parametrize("package", ["turtlesim", "turtlesim_msgs"])
def test_package_name_depends_on_the_distribution(package: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ros_distro, "TURTLESIM_PACKAGE", package)
    assert f"{package}/msg/Pose" == runpy.run_path(turtlesim_types.__file__)["Pose"]._TYPE_NAME


def test_client_of_the_other_type_is_told_the_type(
    make_node: Any, capfd: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(clients, "LOOK_AT_TYPES_S", 0.05)
    monkeypatch.setattr(clients, "MAX_WAIT_FOR_SERVER_S", 0.2)
    node = make_node("old")
    make_node("new").create_service(SpawnSinceKilted, "/spawn", lambda _, response: response)
    client = node.create_client(Spawn, "/spawn")
    assert not client.wait_for_service(timeout_sec=1.0)
    assert capfd.readouterr().err.count(SERVED) == 1
    future = client.call_async(Spawn.Request())
    executor = SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    executor.spin_until_future_complete(future, timeout_sec=20)
    assert str(future.exception()).startswith(f"no response from /spawn: {SERVED}")
    other = node.create_client(Spawn, "/kill")
    assert not other.wait_for_service(timeout_sec=0.3)
    assert capfd.readouterr().err == ""


@pytest.mark.wire
@pytest.mark.usefixtures("domain_id")
def test_command_with_the_other_type_is_told_the_type(
    start_program: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("RMW_IMPLEMENTATION")  # the two are programs
    environment = os.environ | {"ROS_DISTRO": "kilted"}
    serve = (
        "import rclpy\nfrom turtlesim.srv import Spawn\nwith rclpy.init():\n    node = rclpy.create_node('new')\n"
        "    node.create_service(Spawn, '/spawn', lambda _, response: response)\n    rclpy.spin(node)"
    )
    start_program(sys.executable, "-c", serve, env=environment)
    call = start_program("ros2", "service", "call", "/spawn", "turtlesim/srv/Spawn", "{}")
    wait_until(lambda: any(line.startswith(SERVED) for line in call.lines), 30)
