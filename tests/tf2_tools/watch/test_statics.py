"""The static transforms of an observation: those that a file can hold, and a sentence on each other one."""

from __future__ import annotations

import math
from pathlib import Path

from tests.tf2_tools.recordings import START_NS, recorded, transform

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.tf2_tools.static_file import file_text, read_statics
from tfloom.tf2_tools.watch.difference import links_of
from tfloom.tf2_tools.watch.model import Observation
from tfloom.tf2_tools.watch.recorded import observe_recorded
from tfloom.tf2_tools.watch.statics import last_statics, quarrels, unusable


def observed(*transforms: TransformStamped) -> Observation:
    """Return the observation of a recording with these static transforms, one in each message."""
    messages = [
        recorded(START_NS + i, transform, topic="/tf_static") for i, transform in enumerate(transforms, 1)
    ]
    return observe_recorded(messages, "a.mcap")


def static(parent: str, child: str, x: float = 1.0, qw: float = 1.0) -> TransformStamped:
    """Return a static transform whose quaternion has the length `qw`."""
    message = transform(parent, child, START_NS, (x, 0.0, 0.0))
    message.transform.rotation.w = qw
    return message


def test_the_last_transform_of_each_child_is_taken() -> None:
    seen = observed(static("base", "laser"), static("base", "arm"), static("/mast", "/laser", 2.0))
    assert [
        (transform.frame_id, transform.child_frame_id, transform.translation[0])
        for transform in last_statics(seen)
    ] == [
        ("base", "arm", 1.0),
        ("mast", "laser", 2.0),
    ]
    (quarrel,) = quarrels(seen)
    assert quarrel.startswith(
        "'laser' has different static transforms, from a.mcap (parent 'base') and a.mcap ("
    )
    assert unusable(seen) == []


def test_what_no_lookup_can_use_is_left_out(tmp_path: Path) -> None:
    seen = observed(
        static("base", "near", qw=1.004),
        static("base", ""),
        static("own", "/own"),
        static("base", "nan", math.nan),
        static("base", "zero", qw=0.0),
        static("base", "long", qw=1.006),
        static("base", "//slashed"),
        static("a", "c"),
        static("b", "a"),
        static("c", "b"),
        static("base", "laser"),
        static("base", "laser", qw=0.0),
        static("mast", "laser", 7.0, math.inf),
    )
    assert [sentence.partition(" of a.mcap is left out, because ")[::2] for sentence in unusable(seen)] == [
        ("'base' -> ''", "a frame id is empty"),
        ("'own' -> '/own'", "the frame is its own parent"),
        ("'base' -> 'nan'", "its numbers are not finite"),
        ("'base' -> 'zero'", "its quaternion has the length 0, not 1"),
        ("'base' -> 'long'", "its quaternion has the length 1.006, not 1"),
        ("'base' -> '//slashed'", "tf2 rejects lookups of '/slashed'"),
        ("'a' -> 'c'", "it closes a loop"),
        ("'base' -> 'laser'", "its quaternion has the length 0, not 1"),
        ("'mast' -> 'laser'", "its numbers are not finite"),
    ]
    statics = last_statics(seen)
    assert [transform.child_frame_id for transform in statics] == ["a", "b", "near"]
    assert quarrels(seen) == []
    path = tmp_path / "saved.yaml"
    path.write_text(file_text(statics), "utf-8")
    assert [transform.child_frame_id for transform in read_statics(path)] == ["a", "b", "near"]


def test_rejected_transforms_are_no_difference() -> None:
    sound = [static("base", "laser")]
    spoilt = [*sound, static("base", "zero", qw=0.0), static("base", ""), static("own", "own")]
    assert links_of(observed(*spoilt)) == links_of(observed(*sound))
