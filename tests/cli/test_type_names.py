"""Suggestions for a mistyped type name."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import transcript

from tfloom.cli.shared.type_names import did_you_mean_type, nearest_types
from tfloom.workspace.interfaces import known_interfaces


@pytest.mark.parametrize(
    ("name", "kind", "first"),
    [
        ("String", "msg", "std_msgs/msg/String"),
        ("string", "msg", "std_msgs/msg/String"),
        ("std_msgs/msg/string", "msg", "std_msgs/msg/String"),
        ("nav_msgs/msg/Twist", "msg", "geometry_msgs/msg/Twist"),
        ("geometry_msgs/Twst", "msg", "geometry_msgs/msg/Twist"),
        ("geometry_msg/msg/Twist", "msg", "geometry_msgs/msg/Twist"),
        ("LaserScn", "msg", "sensor_msgs/msg/LaserScan"),
        ("Poze", "msg", "geometry_msgs/msg/Pose"),
        ("SetBol", "srv", "std_srvs/srv/SetBool"),
        ("RotateAbsolut", "action", "turtlesim/action/RotateAbsolute"),
    ],
)
def test_nearest_type_is_first(name: str, kind: str, first: str) -> None:
    assert nearest_types(name, known_interfaces(kind))[0] == first


@pytest.mark.parametrize("name", ["no_such/msg/Type", "tf", "", "/"])
def test_distant_names_have_no_suggestion(name: str) -> None:
    assert did_you_mean_type(name, "srv") == ""


def test_live_types_precede_familiar_ones() -> None:
    assert did_you_mean_type("Pose", "msg", {"turtlesim/msg/Pose"}).startswith(
        "\ndid you mean turtlesim/msg/Pose, geometry_msgs/msg/Pose or "
    )
    assert nearest_types("Pos", ["a/msg/Pose"], {"a/msg/Pose"}) == ["a/msg/Pose"]


@pytest.mark.parametrize(
    ("words", "meant"),
    [
        (("topic", "echo", "/x", "String"), "example_interfaces/msg/String"),
        (("topic", "pub", "/x", "String"), "example_interfaces/msg/String"),
        (("service", "call", "/s", "Emty"), "std_srvs/srv/Empty"),
    ],
)
def test_types_on_the_graph_are_suggested(
    words: tuple[str, ...], meant: str, domain_id: int, start_program: Callable[..., object]
) -> None:
    start_program("tfloom", "topic", "pub", "/other", "example_interfaces/msg/String").wait_for("#1")
    answer = transcript.run_here(*words)
    what = {"topic": "message"}.get(words[0], words[0])
    assert answer.exit_code == 1
    assert transcript.without_waiting(answer.text).startswith(
        f"The passed {what} type is invalid\nthere is no {what} type '{words[3]}'\ndid you mean {meant}"
    )
