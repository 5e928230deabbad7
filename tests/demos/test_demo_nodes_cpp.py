"""The programs and launch files of demo_nodes_cpp."""

from __future__ import annotations

import signal
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import Program
from tests.demos.test_demo_nodes_py import end, said

pytestmark = pytest.mark.wire


@pytest.fixture
def start(start_program: Callable[..., Program], domain_id: int) -> Callable[..., Program]:
    return lambda *words: start_program("tfloom", *words)


def test_listener_logs_what_the_talker_publishes(start: Callable[..., Program]) -> None:
    listener = start("run", "demo_nodes_cpp", "listener")
    talker = start("run", "demo_nodes_cpp", "talker")
    talker.wait_for("Publishing: 'Hello World: 2'")
    assert said(talker.lines, "talker")[0] == "Publishing: 'Hello World: 1'"
    listener.wait_for("[listener]: I heard: [Hello World: 2]")
    end(talker, listener)


def test_clients_log_the_sum_of_two_and_three(start: Callable[..., Program]) -> None:
    names = ("add_two_ints_client", "add_two_ints_client_async")
    clients = [start("run", "demo_nodes_cpp", name) for name in names]
    for client in clients:
        client.wait_for("[add_two_ints_client]: service not available, waiting again...")
    server = start("run", "demo_nodes_cpp", "add_two_ints_server")
    for client in clients:
        assert client.wait() == 0
        assert said(client.lines, "add_two_ints_client")[-1] == "Result of add_two_ints: 5"
    assert server.lines[1::2] == ["a: 2 b: 3"] * 2
    end(server, number=signal.SIGTERM)


def test_launch_of_talker_and_listener(start: Callable[..., Program]) -> None:
    launch = start("launch", "demo_nodes_cpp", "talker_listener_launch.xml")
    launch.wait_for("[listener]: I heard: [Hello World: ")
    launch.signal(signal.SIGINT)
    assert launch.wait() == 0


@pytest.mark.parametrize(
    ("file", "programs"),
    [
        ("topics/talker_listener", ["talker", "listener"]),
        ("services/add_two_ints", ["add_two_ints_server", "add_two_ints_client"]),
        ("services/add_two_ints_async", ["add_two_ints_server", "add_two_ints_client_async"]),
    ],
)
@pytest.mark.parametrize("language", ["py", "xml", "yaml"])
def test_launch_files_start_their_programs(file: str, programs: list[str], language: str) -> None:
    from launch import LaunchContext
    from launch.launch_description_sources import AnyLaunchDescriptionSource
    from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions
    from launch_ros.substitutions import FindPackageShare

    share = FindPackageShare("demo_nodes_cpp").perform(LaunchContext())
    path = Path(share, "launch", f"{file}_launch.{language}")
    description = AnyLaunchDescriptionSource(str(path)).get_launch_description(LaunchContext())
    assert [
        perform_substitutions(LaunchContext(), normalize_to_list_of_substitutions(node.node_executable))
        for node in description.entities
    ] == programs
