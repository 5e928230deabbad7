"""The Zenoh wire beside zenoh-ros2-sdk, an implementation of rmw_zenoh's form by others: data and graph, both ways."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import Program, run_to_end, wait_until
from tests.zenoh_ports import NEEDS_ZENOH, use_port_of

from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node

pytestmark = [pytest.mark.ros, NEEDS_ZENOH]

PROGRAM = Path(__file__).parent / "programs" / "zenoh_witness.py"
ENVIRONMENT = Path(__file__).parents[2] / "build" / "zenoh-witness"
WITNESS = "zenoh-ros2-sdk==0.1.8"
INSTALL_S = 600


@pytest.fixture(scope="module")
def witness_python() -> Path:
    """Return the Python of an environment that has the witness; make it if it isn't there."""
    python = ENVIRONMENT / "bin" / "python"
    probe = [python, "-c", "import zenoh_ros2_sdk"]
    if not python.exists() or subprocess.run(probe, capture_output=True, check=False).returncode:
        subprocess.run([sys.executable, "-m", "venv", ENVIRONMENT], check=True)
        done = run_to_end([python, "-m", "pip", "install", "-q", WITNESS], timeout_s=INSTALL_S)
        if done.returncode:
            pytest.skip(f"{WITNESS} can't be installed here: {done.stderr.strip().splitlines()[-1]}")
    return python


@pytest.fixture
def node(domain_id: int, monkeypatch: pytest.MonkeyPatch) -> Iterator[Node]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    with use_port_of(domain_id):
        context = Context()
        context.init(["program"], domain_id=domain_id)
        node = Node("near", context=context)
        yield node
        node.destroy_node()
        context.destroy()


@pytest.fixture
def spin_until(node: Node) -> Iterator[Callable[..., None]]:
    with SingleThreadedExecutor(context=node.context) as executor:
        executor.add_node(node)
        yield lambda condition: wait_until(
            lambda: executor.spin_once(timeout_sec=0.05) or condition(), what=str(condition)
        )


@pytest.fixture
def alone(tmp_path: Path) -> dict[str, str]:
    """Return the environment of the witness, in which it downloads nothing: it looks for definitions on GitHub."""
    return {
        **os.environ,
        "GIT_ALLOW_PROTOCOL": "none",
        "ZENOH_ROS2_SDK_CACHE": str(tmp_path / "cache"),
        "HOME": str(tmp_path),
    }


@pytest.fixture
def witness(
    node: Node,
    alone: dict[str, str],
    domain_id: int,
    witness_python: Path,
    start_program: Callable[..., Program],
) -> Program:
    hashes = (String._TYPE_HASH, AddTwoInts._TYPE_HASH)
    port = os.environ["TFLOOM_ZENOH_PORT"]
    program = start_program(witness_python, PROGRAM, port, *hashes, stdin=subprocess.PIPE, env=alone)
    program.wait_for("ready", 60)
    return program


def tell(program: Program, word: str) -> None:
    program.process.stdin.write(word + "\n")
    program.process.stdin.flush()


def test_topics_pass_both_ways(node: Node, witness: Program, spin_until: Callable[..., None]) -> None:
    heard: list[str] = []
    node.create_subscription(String, "/from_witness", lambda message: heard.append(message.data), 10)
    publisher = node.create_publisher(String, "/to_witness", 10)
    spin_until(lambda: publisher.get_subscription_count() == 1)
    for number in range(5):
        publisher.publish(String(data=f"near {number}"))
    for number in range(5):
        witness.wait_for(f"heard near {number}")

    def hear() -> bool:
        tell(witness, "publish")
        return len(heard) > 3

    spin_until(hear)
    numbers = [int(text.removeprefix("witness ")) for text in heard]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))


def test_services_pass_both_ways(node: Node, witness: Program, spin_until: Callable[..., None]) -> None:
    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        return response

    node.create_service(AddTwoInts, "/near/add", add)
    client = node.create_client(AddTwoInts, "/far/add")
    spin_until(client.service_is_ready)
    future = client.call_async(AddTwoInts.Request(a=40, b=2))
    spin_until(future.done)
    assert future.result().sum == 42
    witness.wait_for("asked 40 2")
    tell(witness, "call")
    spin_until(lambda: any("answered" in line for line in witness.lines))
    assert "answered 42" in witness.output


def test_the_graph_has_the_witness_and_loses_it(
    node: Node, witness: Program, spin_until: Callable[..., None]
) -> None:
    spin_until(lambda: ("witness", "/far") in node.get_node_names_and_namespaces())
    spin_until(lambda: ("/from_witness", ["std_msgs/msg/String"]) in node.get_topic_names_and_types())
    assert ("/far/add", ["example_interfaces/srv/AddTwoInts"]) in node.get_service_names_and_types()
    [info] = node.get_publishers_info_by_topic("/from_witness")
    assert (info.node_name, info.node_namespace) == ("witness", "/far")
    assert info.topic_type == "std_msgs/msg/String"
    witness.end()
    spin_until(lambda: ("witness", "/far") not in node.get_node_names_and_namespaces())


def test_the_witness_sees_this_node(
    node: Node, alone: dict[str, str], witness_python: Path, start_program: Callable[..., Program]
) -> None:
    node.create_publisher(String, "/seen/by/it", 10)
    command = [
        witness_python.parent / "zenoh-ros2",
        "--router",
        f"127.0.0.1:{os.environ['TFLOOM_ZENOH_PORT']}",
    ]

    def listing() -> str:
        """Return what it lists; it waits for the graph a short time only, which may be too short."""
        listed = start_program(*command, "--no-daemon", "topic", "list", "-t", env=alone)
        listed.wait(60)
        return str(listed.output)

    wait_until(lambda: "/seen/by/it [std_msgs/msg/String]" in " ".join(listing().split()))
