"""The launch's node: created on first use, and ROS's time by it."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest

from tfloom.launch.actions.event_actions import Shutdown
from tfloom.launch.actions.log import LogInfo
from tfloom.launch.actions.opaque import OpaqueFunction
from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.ros.actions.node_defaults import SetUseSimTime
from tfloom.launch.ros.actions.ros_timer import ROSTimer
from tfloom.launch.ros.ros_adapters import ROSAdapter, get_ros_adapter, get_ros_node


@pytest.fixture(autouse=True)
def _wire(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")


def threads() -> list[str]:
    return [thread.name for thread in threading.enumerate() if thread.name == "launch_ros"]


@pytest.mark.parametrize("period", [0.01, TextSubstitution(text="0.01")], ids=["number", "text"])
def test_timer_executes_its_actions(launch: Callable[..., object], period: object) -> None:
    ran = launch(ROSTimer(period=period, actions=[LogInfo(msg="now")]))
    assert ran.lines == ["[INFO] [launch.user]: now"]
    assert threads() == []


def test_timer_ends_with_the_launch(launch: Callable[..., object]) -> None:
    ran = launch(
        ROSTimer(period=1000.0, actions=[LogInfo(msg="never")]),
        ROSTimer(period=0.01, actions=[Shutdown(reason="enough")]),
    )
    assert ran.code == 0
    assert ran.lines == []


def test_timer_stands_still_in_simulated_time(launch: Callable[..., object]) -> None:
    values: list[object] = []

    def look(context: LaunchContext) -> None:
        values.append(get_ros_node(context).get_parameter("use_sim_time").value)

    ran = launch(
        SetUseSimTime(True),
        OpaqueFunction(function=look),
        ROSTimer(period=0.01, actions=[LogInfo(msg="never, because nobody publishes /clock")]),
        OpaqueFunction(function=lambda context: [Shutdown(reason="enough")]),
    )
    assert values == [True]
    assert ran.lines == []


def test_adapter_is_one_for_a_launch(context: LaunchContext) -> None:
    adapter = get_ros_adapter(context)
    try:
        assert get_ros_adapter(context) is adapter
        assert get_ros_node(context) is adapter.ros_node
        assert get_ros_node(context).get_name().startswith("launch_ros_")
        assert adapter.ros_context.ok()
        with pytest.raises(RuntimeError, match="Cannot start a ROS adapter that is already running"):
            adapter.start()
    finally:
        adapter.shutdown()
    assert (adapter.ros_node, adapter.ros_context, adapter.ros_executor, threads()) == (None, None, None, [])
    with pytest.raises(RuntimeError, match="Cannot shutdown a ROS adapter that is not running"):
        adapter.shutdown()
    with pytest.raises(RuntimeError, match="the launch has been shut down"):
        get_ros_node(context)


def test_adapter_has_the_given_arguments() -> None:
    adapter = ROSAdapter(argv=["--ros-args", "-r", "__ns:=/away"], autostart=False)
    assert adapter.ros_node is None
    adapter.start()
    try:
        assert adapter.ros_node.get_namespace() == "/away"
        assert adapter.argv == ["--ros-args", "-r", "__ns:=/away"]
    finally:
        adapter.shutdown()


def test_arguments_of_a_launch_are_no_rules_for_its_node() -> None:
    words = ["__ns:=/mine", "speed:=fast", "--ros-args", "-r", "__node:=mine"]
    context = LaunchContext(argv=words)
    adapter = get_ros_adapter(context)
    try:
        assert get_ros_node(context).get_fully_qualified_name() == "/mine"
    finally:
        adapter.shutdown()
