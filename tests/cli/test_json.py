"""`--json`: available on every verb that lists or shows, and valid for a strict parser."""

from __future__ import annotations

import json
import math
import threading
from array import array
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import transcript
from test_usage import VERBS
from tests.spun import Stage, staging

from tfloom.cli.shared.listing import json_text
from tfloom.interfaces.geometry_msgs.msg import Vector3
from tfloom.interfaces.sensor_msgs.msg import LaserScan
from tfloom.node.lifecycle.node import LifecycleNode
from tfloom.turtlesim.node import TurtlesimNode

BAG = str(Path(__file__).parents[1] / "golden" / "bags" / "mcap")
POSE = "/turtle1/pose"
ROTATE = "/turtle1/rotate_absolute"
ASKED = {
    "action find": ("turtlesim/action/RotateAbsolute",),
    "action info": (ROTATE,),
    "action list": (),
    "action type": (ROTATE,),
    "doctor": (),
    "interface list": (),
    "interface package": ("geometry_msgs",),
    "interface packages": (),
    "lifecycle get": (),
    "lifecycle list": ("/a_node",),
    "lifecycle nodes": (),
    "node info": ("/turtlesim",),
    "node list": (),
    "param describe": ("/turtlesim", "background_r"),
    "param dump": ("/turtlesim",),
    "param get": ("/turtlesim", "background_r"),
    "param list": (),
    "pkg executables": (),
    "pkg list": (),
    "service find": ("turtlesim/srv/Spawn",),
    "service info": ("/spawn",),
    "service list": (),
    "service type": ("/spawn",),
    "tf top": ("--bag", BAG),
    "topic echo": ("--once", POSE),
    "topic find": ("turtlesim/msg/Pose",),
    "topic info": (POSE,),
    "topic list": (),
    "topic type": (POSE,),
}
"""What each verb is asked; its answer is never empty."""
ELSEWHERE = {
    "action echo": "tests/cli/test_action.py",
    "component list": "tests/cli/test_component.py",
    "service echo": "tests/cli/test_service.py",
    "tf diff": "tests/cli/test_tf_statics.py",
    "tf doctor": "tests/tf2_tools/diagnosis/test_command.py",
    "tf explain": "tests/cli/test_tf_explain.py",
}
WITHOUT = {
    **dict.fromkeys(["component load", "component unload"], "changes something"),
    **dict.fromkeys(["action send_goal", "service call", "topic pub", "demo", "run"], "does something"),
    **dict.fromkeys(
        ["param delete", "param load", "param set", "lifecycle set", "pkg create", "interface stubs"],
        "changes something",
    ),
    **dict.fromkeys(
        [f"bag {verb}" for verb in ("burst", "convert", "info", "list", "play", "record", "reindex")],
        "works on a bag",
    ),
    **dict.fromkeys(["tf plot", "tf save"], "writes a file"),
    "tf publish": "publishes until Ctrl-C",
    "view": "serves a page until Ctrl-C",
    "zenoh router": "routes until Ctrl-C",
    **dict.fromkeys(["topic bw", "topic delay", "topic hz"], "reports until Ctrl-C"),
    **dict.fromkeys(
        [
            "daemon start",
            "daemon status",
            "daemon stop",
            "component standalone",
            "component types",
            "launch",
            "security",
        ],
        "prints a sentence",
    ),
    **dict.fromkeys(
        ["interface proto", "interface show", "pkg prefix", "pkg xml"], "prints its own text form"
    ),
    **dict.fromkeys(["multicast receive", "multicast send"], "tries a network"),
}
"""Verbs that have no --json, each with its reason."""


def strictly(text: str) -> Any:
    def refuse(constant: str) -> None:
        pytest.fail(f"{constant} is not JSON")

    return json.loads(text, parse_constant=refuse)


def test_each_verb_has_json_or_a_stated_reason() -> None:
    with_json = {verb for verb, parser in VERBS.items() if "--json" in parser.flags()}
    assert with_json == {*ASKED, *ELSEWHERE}, (
        "tests/cli/test_json.py: add a verb with --json to ASKED or ELSEWHERE"
    )
    assert set(VERBS) - with_json == {*WITHOUT} & set(VERBS), (
        "tests/cli/test_json.py: add a verb without it to WITHOUT, with the reason"
    )


@pytest.fixture
def nodes(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Run turtlesim and a node with a lifecycle on the wire inside this process, where discovery needs no wait."""
    for name in ("MIN_WAIT_S", "QUIET_S"):
        monkeypatch.setattr(f"tfloom.cli.shared.graph.{name}", 0.0)
    with staging(Stage) as start:
        stage = start()
        stage.add(TurtlesimNode())
        stage.add(LifecycleNode("a_node"))
        thread = threading.Thread(target=stage.executor.spin)
        thread.start()
        yield
        stage.executor.shutdown()
        thread.join()


@pytest.mark.usefixtures("nodes")
def test_each_json_output_is_valid() -> None:
    for verb, words in ASKED.items():
        answer = transcript.run_here(*verb.split(), "--json", *words)
        assert answer.exit_code == 0, answer
        assert strictly(answer.text), verb


def test_nan_and_infinity_become_null() -> None:
    scan = LaserScan(ranges=[1.5, math.inf, math.nan], range_max=math.inf)
    message = strictly(json_text(scan))
    assert message["ranges"] == [1.5, None, None]
    assert message["range_max"] is None


def test_each_field_type_converts_to_json() -> None:
    values = {"a": array("d", [1.0]), "b": b"\x01\xff", "v": [Vector3(x=2.0)], "t": ("é", True, None)}
    assert strictly(json_text(values)) == {
        "a": [1.0],
        "b": [1, 255],
        "v": [{"x": 2.0, "y": 0.0, "z": 0.0}],
        "t": ["é", True, None],
    }
