"""Which stream a verb's lines are on: the reference's text on stdout, and what tfloom adds on stderr."""

from __future__ import annotations

import sys
from argparse import Namespace
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import transcript

from tfloom.cli.topic import pub

pytestmark = pytest.mark.wire

NODE = """
import rclpy
from std_msgs.msg import Byte, String

rclpy.init()
node = rclpy.create_node("_secret_node")
node.declare_parameter("size", 1)
secret = node.create_publisher(String, "/_secret", 10)
octet = node.create_publisher(Byte, "/octet", 10)
node.create_timer(0.05, lambda: octet.publish(Byte(data=bytes([5]))))
print("ready", flush=True)
rclpy.spin(node)
"""


@pytest.fixture(scope="module")
def node(module_domain_id: int, start_module_program: Callable[..., Any]) -> None:
    """Start a node whose name is hidden, with a hidden topic, and one of bytes."""
    start_module_program(sys.executable, "-c", NODE).wait_for("ready")


def run(*words: str) -> tuple[int, str, str]:
    """Run a verb; return its exit code, and what it printed on stdout and on stderr."""
    out, err = transcript.Output(), transcript.Output()
    return transcript.exit_code_of(words, out, err), out.text, err.text


def test_info_of_an_unknown_action(node: None) -> None:
    assert run("action", "info", "/nope") == (
        0,
        "Action: /nope\nAction clients: 0\nAction servers: 0\n",
        "Unknown action '/nope'\n",
    )


def test_type_of_a_hidden_topic(node: None) -> None:
    code, out, err = run("topic", "type", "/_secret")
    assert (code, out) == (1, "")
    assert err == "Hidden topic '/_secret': ros2 topic --include-hidden-topics type /_secret\n"
    assert run("topic", "--include-hidden-topics", "type", "/_secret") == (0, "std_msgs/msg/String\n", "")


def test_info_of_a_hidden_node(node: None) -> None:
    code, out, err = run("node", "info", "/_secret_node")
    assert (code, out) == (1, "")
    assert err == "Unable to find node '/_secret_node'\nit is hidden: add --include-hidden\n"
    code, out, _ = run("node", "info", "--include-hidden", "/_secret_node")
    assert (code, out.splitlines()[0]) == (0, "/_secret_node")


def test_csv_of_a_byte(node: None) -> None:
    assert run("topic", "echo", "--once", "--csv", "/octet") == (0, "b'\\x05'\n", "")


def test_longest_wait_without_a_wait(node: None) -> None:
    none = {"wait_matching_subscriptions": None, "once": False, "times": 0}
    assert pub._wanted_subscriptions(Namespace(**none, max_wait_time_secs=None)) == 0
    needed = "--wait-matching-subscriptions, --once or --times"
    for alone in ((), ("-1", "-w", "0")):
        done = run("topic", "pub", *alone, "--max-wait-time-secs", "1", "/x", "std_msgs/msg/Empty")
        assert done == (1, "", f"--max-wait-time-secs option is only effective with {needed}\n")
    assert pub._wanted_subscriptions(Namespace(**{**none, "once": True}, max_wait_time_secs=1.0)) == 1


def test_waits_are_told_on_stdout(node: None) -> None:
    code, out, err = run("topic", "pub", "-1", "--max-wait-time-secs", "1.2", "/x", "std_msgs/msg/Empty")
    assert (code, out) == (1, "Waiting for at least 1 matching subscription(s)...\n")
    assert err == "waited 1.2 s for 1 matching subscription(s), there are 0\n"
    code, out, err = run("service", "call", "--timeout", "0.1", "/nope", "std_srvs/srv/Empty")
    assert (code, out) == (1, "waiting for service to become available...\n")
    assert err == "no server of /nope: waited 0.1 s for it\n"
    code, out, err = run("topic", "echo", "/xyz")
    assert (code, out) == (1, "WARNING: topic [/xyz] does not appear to be published yet\n")
    assert err == "Could not determine the type for the passed topic\n"


def test_parameters_of_a_file_for_another_node(node: None, tmp_path: Path) -> None:
    path = tmp_path / "parameters.yaml"
    path.write_text("/a:\n  ros__parameters: {size: 2}\n/**:\n  ros__parameters: {size: 3}\n", "utf-8")
    load = ("param", "load", "--include-hidden-nodes", "/_secret_node", str(path))
    code, out, err = run(*load, "--no-use-wildcard")
    assert (code, out) == (1, "")
    assert err == "Param file does not contain parameters for /_secret_node,only for nodes: ['/a', '/**'] \n"
    assert run(*load) == (0, "Set parameter size successful\n", "")
    path.write_text("/**:\n  ros__parameters: {missing: 2}\n", "utf-8")
    code, out, err = run(*load)
    assert (code, out) == (1, "")
    assert err.startswith("Set parameter missing failed: ")


def test_unknown_interface_of_a_known_package(node: None) -> None:
    code, out, err = run("interface", "show", "std_msgs/msg/Strng")
    assert (code, out) == (1, "")
    first, second = err.splitlines()
    assert first.startswith("Could not find the interface '/")
    assert first.endswith("/std_msgs/msg/Strng.idl'")
    assert second == "did you mean std_msgs/msg/String?"


def test_new_package_and_the_next_commands(tmp_path: Path) -> None:
    words = ("--destination-directory", str(tmp_path), "--node-name", "my_node", "--dependencies", "rclpy")
    code, out, err = run("pkg", "create", "my_pkg", *words)
    lines = out.splitlines()
    assert code == 0
    assert lines[:8] == [
        "going to create a new package",
        "package name: my_pkg",
        f"destination directory: {tmp_path}",
        "package format: 3",
        "version: 0.0.0",
        "description: TODO: Package description",
        lines[6],
        "licenses: ['TODO: License declaration']",
    ]
    assert lines[6].startswith("maintainer: ['")
    assert lines[8:11] == ["build type: ament_python", "dependencies: ['rclpy']", "node_name: my_node"]
    assert {line.split()[0] for line in lines[11:]} == {"creating"}
    assert f"creating folder {tmp_path / 'my_pkg'}" in lines
    assert f"creating {tmp_path / 'my_pkg' / 'my_pkg' / 'my_node.py'}" in lines
    assert (
        "colcon build --packages-select my_pkg\nthen: source install/setup.bash && ros2 run my_pkg my_node"
        in err
    )
