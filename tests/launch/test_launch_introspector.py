"""The text of descriptions."""

from __future__ import annotations

import pytest

from tfloom.launch.actions.event_actions import EmitEvent, RegisterEventHandler
from tfloom.launch.actions.execute_process import ExecuteProcess
from tfloom.launch.actions.log import LogInfo, LogWarning
from tfloom.launch.actions.timer_action import TimerAction
from tfloom.launch.core.base_classes import LaunchDescriptionEntity
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.events.event_handlers import OnProcessExit
from tfloom.launch.events.launch_events import Shutdown
from tfloom.launch.launch_introspector import (
    LaunchIntrospector,
    format_entities,
    format_substitutions,
    indent,
    tree_like_indent,
)
from tfloom.launch.substitutions.variables import LaunchConfiguration


def test_each_kind_of_action() -> None:
    lines = format_entities(
        [
            LogInfo(msg=["a", LaunchConfiguration("b")]),
            LogWarning(msg="c"),
            EmitEvent(event=Shutdown()),
            ExecuteProcess(cmd=["ls", LaunchConfiguration("flags")], cwd="/tmp", env={"A": "1"}, shell=True),
            RegisterEventHandler(OnProcessExit(on_exit=LogInfo(msg="gone"))),
            LaunchDescription(),
        ]
    )
    assert lines[:3] == [
        "LogInfo('a' + LaunchConfig('b'))",
        "LogWarning('c')",
        "EmitEvent(event='launch.events.Shutdown')",
    ]
    assert (
        lines[3]
        == "ExecuteProcess(cmd=['ls', LaunchConfig('flags')], cwd=''/tmp'', env={'A': '1'}, shell=True)"
    )
    assert lines[4].startswith("RegisterEventHandler('<")
    assert lines[4].endswith("'):")
    assert (
        lines[5]
        == "    OnProcessExit(matcher='event == ProcessExited', handler='<actions>', handle_once=False)"
    )
    assert lines[6] == "        LogInfo('gone')"
    assert lines[7].startswith("Unknown entity('<")


def test_an_event_handler_without_a_description() -> None:
    class Handler:
        pass

    handler = Handler()
    lines = format_entities([RegisterEventHandler(handler)])  # type: ignore[arg-type]
    assert lines[1] == f"    EventHandler('{hex(id(handler))}')"


@pytest.mark.parametrize(
    ("lines", "drawn"),
    [
        ([], []),
        (["a"], ["└── a"]),
        (["a", "b"], ["├── a", "└── b"]),
        (["a", "    b", "c"], ["├── a", "│   └── b", "└── c"]),
        (["a", "    b", "        c"], ["├── a", "│   ├── b", "        └── c"]),
    ],
)
def test_tree(lines: list[str], drawn: list[str]) -> None:
    assert tree_like_indent(indent(lines)) == drawn
    assert tree_like_indent(["not indented", *indent(lines)]) == drawn


def test_description_begins_with_its_repr() -> None:
    class Own(Action):
        def __repr__(self) -> str:
            return "own"

    description = LaunchDescription([Own(), LaunchDescriptionEntity()])
    first, second, third = LaunchIntrospector().format_launch_description(description).split("\n")
    assert first == repr(description)
    assert second == "├── Action('own')"
    assert third.startswith("└── Unknown entity('<")
    assert LaunchIntrospector().format_launch_description(LaunchDescription()).startswith("<")


def test_substitutions_are_joined() -> None:
    assert format_substitutions("a") == "'a'"
    assert format_substitutions(["a", LaunchConfiguration("b")]) == "'a' + LaunchConfig('b')"


def test_timers_describe_their_period() -> None:
    from tfloom.launch.ros.actions.ros_timer import ROSTimer

    action = LogInfo(msg="x")
    timer = TimerAction(period=2, actions=[action])
    assert timer.describe() == "TimerAction(period=2.0, actions=<actions>)"
    assert timer.describe_sub_entities() == []
    assert timer.describe_conditional_sub_entities() == [
        ("2.0 seconds pass without being canceled", [action])
    ]
    by_ros = ROSTimer(period=LaunchConfiguration("p"), actions=[action])
    assert by_ros.describe() == "ROSTimer(period=LaunchConfig('p'), actions=<actions>)"


def test_an_action_describes_itself_by_its_repr_and_an_entity_not_at_all() -> None:
    action = Action()
    assert action.describe() == repr(action)
    with pytest.raises(NotImplementedError, match="LaunchDescriptionEntity has no method 'describe'"):
        LaunchDescriptionEntity().describe()
