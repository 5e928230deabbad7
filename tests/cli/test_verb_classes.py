"""The verbs as classes, which programs and other verbs derive from: `ros2topic.verb.echo.EchoVerb` and its like."""

from __future__ import annotations

import argparse
import inspect
import json
import sys
from collections.abc import Callable
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from lifecycle_msgs.msg import Transition
from rclpy.clock import ROSClock
from rclpy.exceptions import InvalidServiceNameException
from rclpy.time import Time
from ros2cli.node.direct import DirectNode
from ros2component import api as component_api
from ros2lifecycle import api as lifecycle_api
from ros2node.api import get_node_names
from ros2topic.verb.bw import ROSTopicBandwidth
from ros2topic.verb.delay import ROSTopicDelay
from ros2topic.verb.hz import ROSTopicHz
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Header, Int8
from tests.cli.extensions import install, run_here

from tfloom.cli.main import COMMANDS
from tfloom.cli.parser import Group, load_verb
from tfloom.cli.plugins.extensions import VerbExtension
from tfloom.cli.verb_classes import verbs

HERE = Path(__file__).parent
MODULE_NAMES = HERE.parent / "golden" / "verb_classes.json"

BRIDGED = '''
from ros2topic.verb.echo import EchoVerb


class BridgedEchoVerb(EchoVerb):
    """Print messages that a bridge sends."""

    def add_arguments(self, parser, cli_name):
        super().add_arguments(parser, cli_name)
        parser.add_argument("--bridge")

    def main(self, *, args):
        print("by", args.bridge, flush=True)
        return EchoVerb.main(self, args=args)
'''


def verb_classes() -> dict[str, list[str]]:
    names: dict[str, list[str]] = json.loads(MODULE_NAMES.read_text("utf-8"))
    return names


SEEN_IN_PROGRAMS = {
    "ros2bag.verb.convert",
    "ros2bag.verb.play",
    "ros2bag.verb.record",
    "ros2pkg.verb.create",
    "ros2topic.verb.bw",
    "ros2topic.verb.delay",
    "ros2topic.verb.echo",
    "ros2topic.verb.hz",
    "ros2topic.verb.info",
    "ros2topic.verb.list",
    "ros2topic.verb.pub",
}
"""The modules of verbs that public programs import, beside those that only packages of ROS 2 itself import."""


@pytest.mark.parametrize("module", sorted(SEEN_IN_PROGRAMS))
def test_reference_s_classes_that_programs_import_are_there(module: str) -> None:
    for name in verb_classes().get(module, ["ConvertVerb", "CreateVerb"]):
        cls = getattr(import_module(module), name, None)
        if name.endswith("Verb") and cls is not None:
            assert issubclass(cls, VerbExtension)
            assert callable(load_verb(cls.CODE)[1])


@pytest.mark.parametrize("module", sorted({*verb_classes(), "ros2component.verb.types"} - SEEN_IN_PROGRAMS))
def test_import_of_another_verb_s_class_names_what_to_do_instead(module: str) -> None:
    package, _, verb = module.split(".")
    expected = (
        rf"No module named '{module}': .*`{package}\.api`, or `ros2cli\.cli\.main\(argv=\[.*'{verb}'\]\)`"
    )
    with pytest.raises(ImportError, match=expected):
        import_module(module)
    with pytest.raises(ImportError, match=expected):
        exec(f"from {package}.verb import {verb}")
    assert import_module(f"{package}.api")


def test_each_class_has_the_summary_of_its_verb() -> None:
    for cls in vars(verbs).values():
        if not (isinstance(cls, type) and "CODE" in vars(cls)):
            continue
        command = cls.CODE[0].split(".")[2]
        group = COMMANDS[command]
        assert isinstance(group, Group)
        (verb,) = (verb for verb in group.verbs if group.code_of(command, verb) == cls.CODE)
        assert inspect.getdoc(cls) == f"{group.verbs[verb]}."


@pytest.mark.wire
def test_derived_verb_runs_as_the_own_one_does(
    tmp_path: Path, domain_id: int, start_program: Callable[..., Any]
) -> None:
    install(tmp_path, {"ros2topic.verb": {"bridged": "my_extensions:BridgedEchoVerb"}}, BRIDGED)
    start_program(
        sys.executable, "-m", "tfloom", "topic", "pub", "-r", "20", "/a", "std_msgs/msg/Int8", "{data: 7}"
    ).wait_for("publishing #1")

    run = partial(run_here, tmp_path, "topic", "bridged")
    done = run("--bridge", "me", "--once", "--field", "data", "/a")
    assert (done.returncode, done.stdout, done.stderr) == (0, "by me\n7\n---\n", "")
    assert "Print messages that a bridge sends" in run("-h").stdout
    failed = run("/a", "std_msgs/msg/Nothing")
    assert (failed.returncode, failed.stdout) == (1, "by None\n")
    assert failed.stderr.startswith("The passed message type is invalid")


@pytest.mark.wire
def test_verb_runs_with_the_few_arguments_that_a_program_gives(
    domain_id: int, capsys: pytest.CaptureFixture[str]
) -> None:
    from ros2topic.verb.info import InfoVerb
    from ros2topic.verb.list import ListVerb

    assert ListVerb().main(args=argparse.Namespace()) == 0
    error = InfoVerb().main(args=argparse.Namespace(topic_name="/no_such"))
    assert str(error).startswith("Unknown topic")
    capsys.readouterr()
    with DirectNode(argparse.Namespace()) as node:
        node.create_publisher(Int8, "/_hidden", 1)
        assert InfoVerb().main(args=argparse.Namespace(topic_name="/_hidden")) in (0, None)
    assert "Publisher count: 1" in capsys.readouterr().out


@pytest.fixture(scope="module")
def nodes(module_domain_id: int, start_module_program: Callable[..., Any]) -> int:
    for program in ("a_lifecycle_node.py", "a_container.py"):
        start_module_program(sys.executable, str(HERE / program)).wait_for("ready")
    return module_domain_id


@pytest.mark.wire
def test_lifecycle_nodes_are_asked_and_changed(nodes: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tfloom.cli.api.answers.TIMEOUT_S", 0.3)
    with DirectNode(argparse.Namespace()) as node:
        assert [name.full_name for name in lifecycle_api.get_node_names(node=node)] == ["/a_node"]
        states = lifecycle_api.call_get_states(node=node, node_names=["/a_node"])
        assert states["/a_node"].label == "unconfigured"
        available = lifecycle_api.call_get_available_transitions(node=node, states=states)["/a_node"]
        assert [description.transition.label for description in available] == ["configure"]
        assert len(lifecycle_api.call_get_transition_graph(node=node, states={"a_node": None})["a_node"]) == 2
        assert lifecycle_api.call_change_states(node=node, transitions={"/a_node": Transition(id=1)}) == {
            "/a_node": True
        }
        assert lifecycle_api.call_get_states(node=node, node_names=["/a_node"])["/a_node"].label == "inactive"
        # A node that isn't there is an error by itself, and the others are answered.
        mixed = lifecycle_api.call_get_states(node=node, node_names=["/nobody", "/a_node"], timeout=0.5)
        assert list(mixed) == ["/nobody", "/a_node"]
        assert str(mixed["/nobody"]) == "service /nobody/get_state is not there"
        assert mixed["/a_node"].label == "inactive"
        assert not list(node.clients)
        # Clients that were created before the one of an invalid name are destroyed, too.
        with pytest.raises(InvalidServiceNameException):
            lifecycle_api.call_get_states(node=node, node_names=["/a_node", "/no name"])
        assert not list(node.clients)


@pytest.mark.wire
def test_components_are_loaded_listed_and_unloaded(nodes: int, monkeypatch: pytest.MonkeyPatch) -> None:
    with DirectNode(argparse.Namespace()) as node:
        found = component_api.find_container_node_names(node=node, node_names=get_node_names(node=node))
        assert [name.full_name for name in found] == ["/a_container"]
        uid, name = component_api.load_component_into_container(
            node=node,
            remote_container_node_name="/a_container",
            package_name="composition",
            plugin_name="composition::Talker",
            node_namespace="/ns",
            log_level="info",
            parameters=["a:=3"],
        )
        assert name == "/ns/talker"
        is_there, components = component_api.get_components_in_container(
            node=node, remote_container_node_name="/a_container"
        )
        assert (is_there, components) == (True, [component_api.ComponentInfo(uid, "/ns/talker")])
        with pytest.raises(RuntimeError, match="Failed to load component: No such plugin in p"):
            component_api.load_component_into_container(
                node=node, remote_container_node_name="/a_container", package_name="p", plugin_name="Nothing"
            )
        for wrong in ({"parameters": ["a=3"]}, {"log_level": "loud"}):
            with pytest.raises(RuntimeError, match=r"is not a parameter|must be one of"):
                component_api.load_component_into_container(
                    node=node,
                    remote_container_node_name="/a_container",
                    package_name="p",
                    plugin_name="x",
                    **wrong,  # type: ignore[arg-type]
                )
        unloaded = component_api.unload_component_from_container(
            node=node, remote_container_node_name="/a_container", component_uids=[uid, 5]
        )
        assert list(unloaded) == [(uid, False, ""), (5, True, "no node found with that id")]
        monkeypatch.setattr("tfloom.cli.api.component.TIMEOUT_S", 0.3)
        nobody = component_api.get_components_in_containers(
            node=node, remote_containers_node_names=["/nobody"]
        )
        assert nobody == {"/nobody": (False, "service /nobody/_container/list_nodes is not there")}


def test_components_that_packages_register(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    marker = tmp_path / "share" / "ament_index" / "resource_index" / "rclcpp_components" / "mine"
    marker.parent.mkdir(parents=True)
    marker.write_text("mine::Talker;lib/libmine.so\nmine::Listener;lib/libmine.so\n", "utf-8")
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    assert component_api.get_registered_component_types() == [("mine", ["mine::Talker", "mine::Listener"])]
    assert component_api.get_package_component_types(package_name="other") == []
    with pytest.raises(ValueError, match="package_name"):
        component_api.get_package_component_types()


@pytest.fixture
def simulated() -> tuple[Any, Callable[[int], None]]:
    """What has a simulated clock as a node has, and what sets its time [ns]."""
    clock = ROSClock()
    clock._set_ros_time_is_active(True)
    node = argparse.Namespace(get_clock=lambda: clock)
    return node, lambda stamp_ns: clock.set_ros_time_override(Time(nanoseconds=stamp_ns))


def test_rates_over_a_window(simulated: Any, capsys: pytest.CaptureFixture[str]) -> None:
    node, set_time = simulated
    rate = ROSTopicHz(node, 3, filter_expr=lambda message: message.data >= 0)
    for second in (10, 11, 12, 14):
        set_time(second * 10**9)
        rate.callback_hz(Int8(data=1), "/a")
        rate.callback_hz(Int8(data=-1), "/a")
    assert rate.get_hz("/other") is None
    assert rate.get_times("/a") == [10**9, 2 * 10**9]
    rate.print_hz("/a")
    expected = "average rate: 0.667\n\tmin: 1.000s max: 2.000s std dev: 0.50000s window: 3\n"
    assert capsys.readouterr().out == expected
    assert rate.get_hz("/a") is None  # nothing new
    assert rate.get_last_printed_tn("/a") == 14 * 10**9
    set_time(5 * 10**9)  # the simulation has started again
    rate.callback_hz(Int8(), "/a")
    set_time(7 * 10**9)
    rate.callback_hz(Int8(), "/a")
    assert rate.get_hz("/a") == (0.5e-9, 2e9, 2e9, 0.0, 2)


def test_bandwidth_and_delay(simulated: Any, capsys: pytest.CaptureFixture[str]) -> None:
    node, set_time = simulated
    bandwidth, delay = ROSTopicBandwidth(node, 10), ROSTopicDelay(node, 10)
    assert (bandwidth.get_bw(), delay.get_delay()) == (None, None)
    for second in (10, 11, 12):
        set_time(second * 10**9)
        bandwidth.callback(b"x" * 100 * (second - 9))
        message = Clock()
        header = argparse.Namespace(header=Header())
        header.header.stamp.sec = second - 1
        delay.callback_delay(header)
        with pytest.raises(RuntimeError, match="msg does not have header"):
            delay.callback_delay(message)
    assert bandwidth.get_bw() == (300.0, 3, 200.0, 100, 300)
    bandwidth.print_bw()
    delay.print_delay()
    delay.print_delay()  # nothing new
    assert capsys.readouterr().out == (
        "300 B/s from 3 messages\n\tMessage size mean: 200 B min: 100 B max: 300 B\n"
        "average delay: 1.000\n\tmin: 1.000s max: 1.000s std dev: 0.00000s window: 3\n"
    )


def test_bare_import_of_the_generator_is_no_error_and_its_names_tell_what_to_do() -> None:
    import rosidl_generator_py

    assert not hasattr(rosidl_generator_py, "__wrapped__")
    with pytest.raises(ImportError, match="interfaces stubs DIR"):
        from rosidl_generator_py import generate_py  # noqa: F401
    with pytest.raises(ImportError, match="interfaces stubs DIR"):
        import rosidl_generator_py.import_type_support_impl
    assert find_spec("rosidl_generator_py.import_type_support_impl") is None
    assert find_spec("ros2node.verb.info") is None
