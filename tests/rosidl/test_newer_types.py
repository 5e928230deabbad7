"""Interfaces that today's Jazzy, Kilted and Lyrical have beside those of `tests/golden/jazzy_types.jsonl`.

`tests/golden/newer_type_hashes.jsonl` has the hashes of ROS's own definitions, by the first distribution that has one
of this form. They were computed as those here are: that the computation is right, `test_golden_types.py` says.
"""

from __future__ import annotations

import importlib
import json
import os
import sys
from enum import IntEnum
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tests.each import for_each

from tfloom.interfaces.rosgraph_msgs.msg import QoSProfile, TypeHash
from tfloom.interfaces.sensor_msgs.msg import PointField
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, ReliabilityPolicy
from tfloom.rosidl import cdr
from tfloom.rosidl.registry import find_class, get_message_class
from tfloom.workspace.get_interfaces import get_interfaces

GOLDEN = Path(__file__).parents[1] / "golden"
ROWS = [json.loads(line) for line in (GOLDEN / "newer_type_hashes.jsonl").read_text("utf-8").splitlines()]
OLDER = {
    entry["type"]: entry["type_hash"]
    for entry in map(json.loads, (GOLDEN / "jazzy_types.jsonl").read_text("utf-8").splitlines())
}
HASHES = OLDER | {row["type"]: row["hash"] for row in reversed(ROWS) if row["type"] not in OLDER}
"""Of each type, that of the first distribution which has it."""
LATER = {
    "lifecycle_msgs/msg/TransitionEvent",
    "rosbag2_interfaces/srv/Record",
    "rosbag2_interfaces/srv/Resume",
    "rosbag2_interfaces/srv/SplitBagfile",
    "rosbag2_interfaces/srv/Stop",
}
"""What Lyrical has in another form."""


@for_each(sorted({row["type"] for row in ROWS}))
def test_hash_is_that_of_the_first_distribution(name: str) -> None:
    assert HASHES[name] == find_class(name)._TYPE_HASH


@pytest.mark.parametrize("distro", ["kilted", "lyrical"])
def test_hash_of_what_is_later_in_another_form(distro: str) -> None:
    """Each class has the hash of the distribution's form, by its class and by the text of its definition."""
    program = f"""
import importlib
from tfloom.rosidl.sources import find_interface, find_message
from tfloom.rosidl.type_hash import type_hash
for name in {sorted(LATER)}:
    package, kind, base = name.split("/")
    imported = getattr(importlib.import_module(f"{{package}}.{{kind}}"), base)
    assert type_hash(find_interface(name), find_message) == imported._TYPE_HASH, name
    print(name, imported._TYPE_HASH)
"""
    done = run_to_end([sys.executable, "-c", program], env=os.environ | {"ROS_DISTRO": distro})
    assert done.returncode == 0, done.stderr
    later = {row["type"]: row["hash"] for row in ROWS if row["distribution"] == "lyrical"}
    assert dict(line.split() for line in done.stdout.splitlines()) == {
        name: later[name] if distro == "lyrical" else find_class(name)._TYPE_HASH for name in LATER
    }


def test_what_is_later_in_another_form() -> None:
    assert {row["type"] for row in ROWS if row["hash"] != find_class(row["type"])._TYPE_HASH} == LATER
    assert {row["distribution"] for row in ROWS if row["type"] in LATER} == {"jazzy", "lyrical"}


@for_each(sorted({row["type"] for row in ROWS}))
def test_each_is_listed_and_imported(name: str) -> None:
    package, kind, base = name.split("/")
    # The Python modules of turtlesim_msgs have the classes that the distribution has, here turtlesim's.
    imported = getattr(importlib.import_module(f"{package}.{kind}"), base)
    assert imported is find_class(name.replace("turtlesim_msgs/", "turtlesim/"))
    assert f"{kind}/{base}" in get_interfaces()[package]
    if kind == "msg":
        made = get_message_class(name)()
        assert cdr.decode(type(made), cdr.encode(made)) == made


def test_types_of_a_point_that_pcl_has() -> None:
    assert (PointField.INT64, PointField.UINT64, PointField.BOOL) == (9, 10, 11)


@pytest.mark.parametrize(
    "policy",
    [HistoryPolicy, ReliabilityPolicy, DurabilityPolicy, LivelinessPolicy],
    ids=lambda policy: policy.__name__,
)
def test_policies_have_the_numbers_of_rmw(policy: type[IntEnum]) -> None:
    kind = policy.__name__.removesuffix("Policy").upper()
    constants = {name: value for name, value in vars(QoSProfile).items() if name.startswith(f"{kind}_")}
    assert constants == {f"{kind}_{choice.name}": choice.value for choice in policy}


def test_hash_of_a_type_has_the_version_of_rihs01() -> None:
    assert TypeHash().version == 1
