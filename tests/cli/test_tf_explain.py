"""`tf explain` on broadcasters over DDS: nodes by name, what to wait for, exit codes."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from tfloom.cli.shared.graph import joined_participant
from tfloom.cli.tf import explain as explain_module
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rmw.base import NodeName
from tfloom.rmw.qos import DurabilityPolicy, QoS
from tfloom.rmw.typed_names import topic_of
from tfloom.tf2_tools.static_file import encoded, file_text
from tfloom.tf2_tools.static_transform import StaticTransform
from tfloom.tf2_tools.watch.model import Observation

MAX_EXPLANATIONS = 12
"""Explanations until one receives the transforms in the other order."""
BROADCASTER = Path(__file__).with_name("a_broadcaster.py")
NO_TURN = (0.0, 0.0, 0.0, 1.0)
STATICS = [
    StaticTransform("base", "laser", (0.5, 0.0, 0.0), NO_TURN),
    StaticTransform("rig", "camera", (0.0, 0.0, 0.0), NO_TURN),
]

Explain = Callable[..., tuple[int, str]]


@pytest.fixture(scope="module")
def graph(
    module_domain_id: int, start_module_program: Callable[..., Any], tmp_path_factory: pytest.TempPathFactory
) -> None:
    """Start /odometry (odom -> base, 50 Hz), /localization (map -> odom, 10 Hz, 0.08 s late) and a file of statics."""
    path = tmp_path_factory.mktemp("statics") / "robot.yaml"
    path.write_text(file_text(STATICS))
    start_module_program("tfloom", "tf", "publish", path).wait_for("until Ctrl-C")
    start_module_program("python", BROADCASTER).wait_for("broadcasting")


@pytest.fixture
def explain(graph: None, run_tf: Explain) -> Explain:
    """Run `tf explain …` to its end; return exit code and output."""
    return partial(run_tf, "explain")


def test_the_chain_names_each_node(explain: Explain) -> None:
    code, text = explain("map", "laser", "--listen", "0.5")
    assert code == 0
    assert "The lookup of map from laser at the latest time succeeds." in text
    rows = {
        line.split("  ")[-1].split(",")[0]: line
        for line in text.splitlines()
        if " -> " in line and "up" in line
    }
    assert set(rows) == {"/static_transforms_robot", "/odometry", "/localization"}
    delay_s = float(rows["/localization"].partition("delay ")[2].split()[0])
    assert 0.08 <= delay_s < 1.0  # what a busy machine adds
    assert "limited by map -> odom of /localization" in text


def test_a_lookup_for_now_says_how_long_to_wait(explain: Explain) -> None:
    code, text = explain("map", "laser", "--at", "now", "--json")
    values = json.loads(text)
    assert (code, values["outcome"], values["newest_limited_by"]) == (1, "future", "odom")
    assert "extrapolation into the future" in values["error"]
    (_, why, what) = values["advice"]
    assert why.startswith("/localization sends one each 0.1")
    timeout_s = float(what.split("a timeout of ")[1].split()[0])
    assert 0.18 < timeout_s < 1.0


def test_a_time_in_the_past_is_there_after_listening(explain: Explain) -> None:
    code, text = explain("map", "laser", "--at", "-0.5")
    assert (code, "(0.500 s ago) succeeds" in text) == (0, True)
    code, text = explain("map", "laser", "--at", "-100", "--wait", "1", "--listen", "0.1")
    assert (code, "This command has listened for" in text) == (1, True)


def test_node_that_is_listed_after_its_transforms_is_named(
    domain_id: int, run_tf: Explain, monkeypatch: pytest.MonkeyPatch
) -> None:
    node = NodeName("/", "late")
    latched = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL)
    has_names = explain_module._has_names
    with joined_participant() as participant:
        writer = participant.create_writer(node, topic_of(TFMessage, "/tf_static"), latched)
        writer.write(encoded(STATICS, 1))

        def list_then(seen: Observation) -> bool:
            if seen.edges and node not in participant.graph.nodes():
                assert not has_names(seen)
                participant.add_node(node)
            return has_names(seen)

        monkeypatch.setattr(explain_module, "_has_names", list_then)
        code, text = run_tf("explain", "base", "laser")
    assert code == 0
    assert " /late\n" in text


@pytest.mark.parametrize("parents", [("left", "right"), ("right", "left")])
def test_both_publishers_of_a_child_with_two_parents_are_named(
    domain_id: int, start_program: Callable[..., Any], run_tf: Explain, parents: tuple[str, str]
) -> None:
    """Which of two latched transforms comes last, and so replaces the other, may differ between programs."""
    for parent in parents:
        node = f"__node:={parent}_node"
        frames = ("--frame-id", parent, "--child-frame-id", "base")
        program = start_program(
            "tfloom", "run", "tf2_ros", "static_transform_publisher", *frames, "--ros-args", "-r", node
        )
        program.wait_for("Spinning until stopped")
    for _ in range(MAX_EXPLANATIONS):
        _, text = run_tf("explain", parents[0], "base", "--listen", "0.5", "--wait", "2")
        if "fails" in text:
            break
    assert "'base' is sent with several parents, of which a buffer keeps the last" in text
    publishers = "/left_node on /tf_static (parent 'left') and /right_node on /tf_static (parent 'right')"
    assert publishers in text


def test_frames_that_are_not_there_or_not_connected(explain: Explain) -> None:
    code, text = explain("map", "camera", "--wait", "0.5")
    assert (code, "'camera' is in the tree of 'rig'" in text) == (1, True)
    code, text = explain("map", "Laser ", "--wait", "0.5")
    assert (code, "Similar: 'laser'" in text) == (1, True)


def test_a_publisher_that_listeners_do_not_hear_is_named(explain: Explain) -> None:
    code, text = explain("map", "gps", "--wait", "1")
    assert code == 1
    assert "/localization publishes it on /tf, but transform listeners receive nothing from there" in text
    assert "reliability" in text


def test_a_time_that_is_none(explain: Explain) -> None:
    code, text = explain("map", "laser", "--at", "soon")
    assert (code, "must be latest, now, seconds with a sign" in text) == (2, True)


def test_a_file_is_explained_without_a_graph(run_tf: Explain, tmp_path: Path) -> None:
    path = tmp_path / "robot.yaml"
    path.write_text(file_text(STATICS))
    code, text = run_tf("explain", "base", "laser", "--bag", path)
    assert (code, f"static, valid at any time =======  {path}" in text) == (0, True)
