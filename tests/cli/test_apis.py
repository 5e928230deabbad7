"""The functions that programs import from the packages of ROS's commands: `ros2topic.api` and its like."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import rclpy
from rclpy.qos import QoSDurabilityPolicy, QoSReliabilityPolicy, qos_profile_sensor_data
from ros2action.api import get_action_clients_and_servers, get_action_names, get_action_names_and_types
from ros2bag.api import convert_yaml_to_qos_profile, create_bag_directory, dict_to_duration, print_error
from ros2cli.helpers import unsigned_int, wait_for
from ros2cli.node import NODE_NAME_PREFIX
from ros2cli.node.direct import DirectNode
from ros2cli.node.strategy import NodeStrategy, add_arguments
from ros2interface.api import interface_to_yaml, type_completer
from ros2node import api as node_api
from ros2param import api as param_api
from ros2pkg.api import PackageNotFound, get_executable_paths, get_package_names, get_prefix_path
from ros2run.api import MultipleExecutables, get_executable_path, run_executable
from ros2service.api import get_service_class, get_service_names, get_service_names_and_types
from ros2topic import api as topic_api
from std_msgs.msg import Int8, String
from std_srvs.srv import Empty

A_NODE = """
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from std_msgs.msg import String
from std_srvs.srv import Empty

rclpy.init()
node = rclpy.create_node("there", namespace="/over")
node.declare_parameter("size", 3)
node.create_publisher(String, "/words", 10)
node.create_publisher(String, "/_secret", 10)
node.create_subscription(String, "heard", print, 10)
node.create_service(Empty, "reset", lambda request, response: response)
node.create_client(Empty, "/elsewhere")
server = ActionServer(node, Fibonacci, "count", lambda goal: Fibonacci.Result())
client = ActionClient(node, Fibonacci, "/other")
print("ready", flush=True)
rclpy.spin(node)
"""


@pytest.fixture(scope="module")
def there(module_domain_id: int, start_module_program: Callable[..., Any]) -> int:
    """A node `/over/there` with an end of each kind."""
    start_module_program(sys.executable, "-c", A_NODE).wait_for("ready")
    return module_domain_id


@pytest.fixture
def strategy(there: int) -> Iterator[NodeStrategy]:
    with NodeStrategy(argparse.Namespace(spin_time=5.0)) as node:
        yield node


pytestmark = pytest.mark.wire
OF_EVERY_NODE = {"/parameter_events", "/rosout"}


def test_topics(strategy: NodeStrategy) -> None:
    assert {*topic_api.get_topic_names(node=strategy)} == {"/words", "/over/heard", *OF_EVERY_NODE}
    topics = dict(topic_api.get_topic_names_and_types(node=strategy, include_hidden_topics=True))
    assert topics["/_secret"] == ["std_msgs/msg/String"]
    assert topic_api.get_msg_class(strategy, "/words") is String
    assert topic_api.get_msg_class(strategy, "words") is String
    assert topic_api.get_msg_class(strategy, "/_secret") is None
    assert topic_api.get_msg_class(strategy, "/_secret", include_hidden_topics=True) is String
    strategy.direct_node.create_publisher(Int8, "/words", 10)
    with pytest.raises(RuntimeError, match=r"more than one type: \[std_msgs/msg/Int8, std_msgs/msg/String\]"):
        topic_api.get_msg_class(strategy, "/words")


def test_class_of_a_topic_that_is_awaited(there: int, capsys: pytest.CaptureFixture[str]) -> None:
    with DirectNode(None) as node:
        names = iter([[], [], [("/late", ["std_msgs/msg/Int8"])]])
        found: list[Any] = []

        class Later:
            def get_topic_names_and_types(self) -> list[tuple[str, list[str]]]:
                found.append(next(names, [("/late", ["std_msgs/msg/Int8"])]))
                return found[-1]

            def get_namespace(self) -> str:
                return node.get_namespace()

        assert topic_api.get_msg_class(Later(), "late", blocking=True) is Int8  # type: ignore[arg-type]
    assert len(found) >= 3
    assert capsys.readouterr().out == "WARNING: topic [late] does not appear to be published yet\n"


def test_nodes(strategy: NodeStrategy) -> None:
    assert node_api.get_node_names(node=strategy) == [node_api.NodeName("there", "/over", "/over/there")]
    hidden = {name.name for name in node_api.get_node_names(node=strategy, include_hidden_nodes=True)}
    assert hidden == {"there", f"{NODE_NAME_PREFIX}_{os.getpid()}"}
    assert node_api.wait_for_node(strategy, False, "/over/there", 5.0)
    assert not node_api.wait_for_node(strategy, False, "/nobody", 0.0)


def test_what_a_node_has(strategy: NodeStrategy) -> None:
    def names(get: Callable[..., Any], **options: bool) -> set[str]:
        return {info.name for info in get(node=strategy, remote_node_name="/over/there", **options)}

    assert names(node_api.get_publisher_info) == {"/words", *OF_EVERY_NODE}
    assert "/_secret" in names(node_api.get_publisher_info, include_hidden=True)
    assert names(node_api.get_subscriber_info) == {"/over/heard"}
    assert {"/over/reset", "/over/there/get_parameters"} <= names(node_api.get_service_server_info)
    assert names(node_api.get_service_client_info) == {"/elsewhere"}
    assert names(node_api.get_action_server_info) == {"/over/count"}
    assert names(node_api.get_action_client_info) == {"/other"}
    (action,) = node_api.get_action_server_info(node=strategy, remote_node_name="over/there")
    assert action == ("/over/count", ["example_interfaces/action/Fibonacci"])
    with pytest.raises(RuntimeError):
        node_api.get_publisher_info(node=strategy, remote_node_name="/nobody")


def test_services(strategy: NodeStrategy) -> None:
    services = dict(get_service_names_and_types(node=strategy))
    assert services["/over/reset"] == ["std_srvs/srv/Empty"]
    assert "/over/count/_action/send_goal" not in services
    assert "/over/count/_action/send_goal" in get_service_names(node=strategy, include_hidden_services=True)
    assert get_service_class(strategy, "over/reset", False) is Empty
    assert get_service_class(strategy, "/nowhere", False) is None


def test_actions(strategy: NodeStrategy) -> None:
    kind = ["example_interfaces/action/Fibonacci"]
    assert get_action_names_and_types(node=strategy) == [("/other", kind), ("/over/count", kind)]
    assert get_action_names(node=strategy) == ["/other", "/over/count"]
    assert get_action_clients_and_servers(node=strategy, action_name="/over/count") == (
        [],
        [("/over/there", kind)],
    )
    clients, servers = get_action_clients_and_servers(node=strategy, action_name="other")
    assert (clients, servers) == ([("/over/there", kind)], [])
    assert strategy.get_action_names_and_types() == [("/other", kind), ("/over/count", kind)]


def test_parameters(there: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    where = {"node_name": "/over/there"}
    with DirectNode(argparse.Namespace()) as node:
        future = param_api.call_list_parameters(node=node, **where)
        assert future is not None
        assert "size" in future.result().result.names
        (value,) = param_api.call_get_parameters(node=node, parameter_names=["size"], **where).values
        assert param_api.get_value(parameter_value=value) == 3
        (descriptor,) = param_api.call_describe_parameters(
            node=node, parameter_names=["size"], **where
        ).descriptors
        assert param_api.get_parameter_type_string(descriptor.type) == "integer"
        (result,) = param_api.call_set_parameters(
            node=node, parameters=[rclpy.Parameter("size", value=4)], **where
        ).results
        assert result.successful
        path = tmp_path / "p.yaml"
        path.write_text("/over/there:\n  ros__parameters: {size: 5, missing: 1}\n", "utf-8")
        param_api.load_parameter_file(node=node, parameter_file=str(path), use_wildcard=True, **where)
        (value,) = param_api.call_get_parameters(node=node, parameter_names=["size"], **where).values
        assert value.integer_value == 5
        path.write_text("/elsewhere:\n  ros__parameters: {size: 6}\n", "utf-8")
        with pytest.raises(RuntimeError, match="not contain parameters for /over/there,only for nodes: "):
            param_api.load_parameter_file(node=node, parameter_file=str(path), use_wildcard=True, **where)
        (value,) = param_api.call_get_parameters(node=node, parameter_names=["size"], **where).values
        assert value.integer_value == 5
    printed = capsys.readouterr()
    assert printed.out == "Set parameter size successful\n"
    assert printed.err.startswith("Set parameter missing failed: ")


def test_parameters_of_no_node(there: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tfloom.cli.api.param.TIMEOUT_S", 0.0)
    with DirectNode(None) as node:
        assert param_api.call_list_parameters(node=node, node_name="/nobody") is None
        with pytest.raises(RuntimeError, match="Wait for service timed out"):
            param_api.call_get_parameters(node=node, node_name="/nobody", parameter_names=[])


def test_direct_node_in_a_program_with_nodes(there: int) -> None:
    rclpy.init()
    try:
        with DirectNode(argparse.Namespace(spin_time=0.0), node_name="mine") as node:
            assert (node.get_name(), node.node) == ("mine", node)
            future = rclpy.task.Future()
            future.set_result(1)
            rclpy.spin_until_future_complete(node, future)
        assert rclpy.ok()
        with pytest.raises(rclpy.exceptions.InvalidHandle):
            node.create_publisher(String, "x", 1)
    finally:
        rclpy.shutdown()


def test_strategy_joins_no_domain_before_its_first_question(there: int) -> None:
    with NodeStrategy({}) as node:
        assert node.daemon_node is None
        assert not rclpy.ok()
        assert node.get_name() == f"{NODE_NAME_PREFIX}_{os.getpid()}"
        assert rclpy.ok()
    assert not rclpy.ok()


def test_arguments_of_nodes() -> None:
    parser = argparse.ArgumentParser()
    add_arguments(parser)
    args = parser.parse_args(["--spin-time", "2", "-s", "--no-daemon"])
    assert (args.spin_time, args.use_sim_time, args.no_daemon) == (2.0, True, True)


def test_completers(there: int) -> None:
    args = argparse.Namespace(topic_name="words", topic_type="std_msgs/msg/Int8", spin_time=5.0)
    assert topic_api.TopicTypeCompleter()("", args) == ["std_msgs/msg/String"]
    args.topic_name = "/none"
    assert "nav_msgs/msg/Odometry" in topic_api.TopicTypeCompleter()("", args)
    assert topic_api.TopicMessagePrototypeCompleter()("", args) == ["data: 0\n"]
    assert node_api.NodeNameCompleter()("", args) == ["/over/there"]
    assert "std_srvs/srv/Empty" in type_completer()


def test_names_of_nodes() -> None:
    full_names = [node_api.get_absolute_node_name(name) for name in ("a", "/a/b", "")]
    assert full_names == ["/a", "/a/b", None]
    assert node_api.parse_node_name("a/b") == node_api.NodeName("b", "/a", "/a/b")
    assert node_api.parse_node_name("/b") == node_api.NodeName("b", "/", "/b")
    assert (node_api.has_duplicates([1, 2, 1]), node_api.has_duplicates([1, 2])) == (True, False)


def test_profiles_from_short_keys() -> None:
    profile = topic_api.qos_profile_from_short_keys("sensor_data", reliability="reliable", depth=7)
    assert (profile.reliability, profile.depth) == (QoSReliabilityPolicy.RELIABLE, 7)
    assert (qos_profile_sensor_data.reliability, qos_profile_sensor_data.depth) == (
        QoSReliabilityPolicy.BEST_EFFORT,
        5,
    )
    late = topic_api.qos_profile_from_short_keys("system_default", durability="transient_local")
    assert (late.durability, late.depth) == (QoSDurabilityPolicy.TRANSIENT_LOCAL, 1)
    lease = topic_api.qos_profile_from_short_keys(
        "default", liveliness_lease_duration_s=1.5
    ).liveliness_lease_duration
    assert lease.nanoseconds == 1_500_000_000
    parser = argparse.ArgumentParser()
    topic_api.add_qos_arguments(parser, "publish", "sensor_data")
    args = parser.parse_args(["--qos-depth", "3", "--qos-history", "keep_all"])
    assert (args.qos_profile, args.qos_depth, args.qos_history) == ("sensor_data", 3, "keep_all")


def test_numbers_and_waits() -> None:
    assert (topic_api.positive_int("3"), unsigned_int("0")) == (3, 0)
    for convert, text in ((topic_api.positive_int, "0"), (unsigned_int, "-1"), (topic_api.positive_int, "x")):
        with pytest.raises(argparse.ArgumentTypeError):
            convert(text)
    calls = iter([False, False, True])
    assert wait_for(lambda: next(calls), None, 0.001)
    assert not wait_for(lambda: False, 0.0)


def test_packages_and_programs(tmp_path: Path) -> None:
    assert {"turtlesim", "rclpy"} <= {*get_package_names()}
    assert get_prefix_path("turtlesim")
    assert get_prefix_path("nope") is None
    with pytest.raises(PackageNotFound):
        get_executable_paths(package_name="nope")
    assert get_executable_paths(package_name="rclpy") == []
    paths = get_executable_paths(package_name="turtlesim")
    assert [Path(path).name for path in paths] == [
        "draw_square",
        "mimic",
        "turtle_teleop_key",
        "turtlesim_node",
    ]
    assert all(os.access(path, os.X_OK) for path in paths)
    path = get_executable_path(package_name="demo_nodes_py", executable_name="talker")
    assert path is not None
    assert Path(path).name == "talker"
    assert b"from tfloom.cli.run import run_here" in Path(path).read_bytes()
    assert get_executable_path(package_name="demo_nodes_py", executable_name="nope") is None


def test_programs_of_a_workspace(prefix: Path, capfd: pytest.CaptureFixture[str]) -> None:
    twice, once = (prefix / "lib" / "my_pkg" / name for name in ("a/twice", "b/once"))
    for program in (twice, once):
        program.parent.mkdir(parents=True)
        program.write_text("#!/bin/sh\necho $*\nexit 3\n", "utf-8")
        program.chmod(0o755)
    path = get_executable_path(package_name="my_pkg", executable_name="once")
    assert path == str(once)
    assert run_executable(path=path, argv=["x", "y"]) == 3
    printed = capfd.readouterr()
    assert (printed.out, printed.err) == ("x y\n", "[ros2run]: Process exited with failure 3\n")
    once.rename(once.with_name("twice"))
    with pytest.raises(MultipleExecutables) as error:
        get_executable_path(package_name="my_pkg", executable_name="twice")
    assert len(error.value.paths) == 2


def test_interfaces_as_yaml() -> None:
    assert interface_to_yaml("std_msgs/msg/Int8") == "data: 0\n"
    assert interface_to_yaml("std_srvs/srv/SetBool") == "data: false\n"


def test_bags(tmp_path: Path) -> None:
    profiles = convert_yaml_to_qos_profile(
        {"/a": {"depth": 3, "reliability": "best_effort", "deadline": {"sec": 1, "nsec": 5}}}
    )
    assert (profiles["/a"].depth, profiles["/a"].reliability) == (3, QoSReliabilityPolicy.BEST_EFFORT)
    assert profiles["/a"].deadline.nanoseconds == 1_000_000_005
    with pytest.raises(ValueError, match="Unexpected key `color`"):
        convert_yaml_to_qos_profile({"/a": {"color": 1}})
    with pytest.raises(ValueError, match=r"both seconds \(sec\) and nanoseconds \(nsec\)"):
        dict_to_duration({"sec": 1})
    assert create_bag_directory(str(tmp_path / "bag")) is None
    assert "Could not create bag folder" in (create_bag_directory(str(tmp_path / "bag")) or "")
    assert print_error("x") == "[ERROR] [ros2bag]: x"
