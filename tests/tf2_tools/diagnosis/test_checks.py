"""The checks of `tf doctor` at their limits, without a wire; test_faults.py has each of them on a graph."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import count

import pytest
from tests.tf2_tools.diagnosis.observing import START_S, S, Scene

from tfloom.rmw.base import EndpointInfo, NodeName, Topic
from tfloom.rmw.qos import DurabilityPolicy, QoS, ReliabilityPolicy
from tfloom.tf2_tools.diagnosis.finding import Source
from tfloom.tf2_tools.diagnosis.report import diagnose
from tfloom.tf2_tools.diagnosis.subject import FrameUse, Subject


def test_a_steady_edge_has_no_findings() -> None:
    scene = Scene()
    scene.steadily("map", "odom")
    assert scene.findings() == []


def test_several_publishers_may_be_of_one_name() -> None:
    twice = Scene()
    for step in range(50):
        for process in (1, 2):
            twice.send("map", "odom", step * 0.02 + process * 0.005, process=process, x=step + process / 100)
    finding = twice.findings()[0]
    assert finding.code == "TF101"
    assert [source.node for source in finding.sources] == ["/node", "/node"]


def test_a_killed_node_that_restarts_is_one() -> None:
    scene = Scene()
    for step in range(50):
        scene.send("map", "odom", step * 0.02, process=1, x=step * 0.01)
    for step in range(50, 100):
        scene.send("map", "odom", step * 0.02 + 0.2, process=2, x=step * 0.01)
    assert scene.codes(max_gap_s=3.0) == []
    scene.send("map", "odom", 2.5, node="other", x=1.0)
    assert scene.codes(max_gap_s=3.0) == ["TF101"]
    equal = Scene()
    for process in (1, 2):
        equal.send("map", "odom", 0.0, process=process, static=True)
    assert equal.codes() == ["TF101"]


def test_parents_that_change_once_do_not_go_back_and_forth() -> None:
    scene = Scene()
    scene.steadily("map", "a", 1, static=True)
    scene.steadily("map", "b", 1, static=True)
    scene.steadily("a", "cup", 20)
    for step in range(20, 40):
        scene.send("b", "cup", step * 0.02)
    assert "TF103" not in scene.codes()
    scene.send("a", "cup", 0.82)
    assert "TF103" in scene.codes()


def test_trees_name_the_publishers_of_the_smaller_ones() -> None:
    scene = Scene()
    for child in ("odom", "base", "laser"):
        scene.send("map", child, static=True, node="robot")
    scene.send("table", "cup", static=True, node="vision")
    finding = scene.findings()[0]
    assert (finding.code, finding.frames) == ("TF105", ["map", "table"])
    assert [source.node for source in finding.sources] == ["/vision"]


def test_a_frame_whose_name_is_too_long_is_not_left_out_in_silence() -> None:
    scene = Scene()
    scene.steadily("map", "odom")
    scene.send("map", "x" * 1_000_000, static=True, node="wild")
    (finding,) = scene.findings()
    assert finding.code == "TF204"
    assert finding.summary.startswith(
        "1 transform of /wild on /tf_static can't be checked: a name of more than"
    )
    assert [source.node for source in finding.sources] == ["/wild"]


def test_a_frame_whose_name_is_too_long_is_a_transform_that_came() -> None:
    scene = Scene()
    scene.send("map", "x" * 1_000_000, static=True)
    assert scene.codes() == ["TF204"]


def test_slashes_do_not_part_trees() -> None:
    scene = Scene()
    scene.send("/map", "/odom", static=True)
    scene.send("odom", "base", static=True)
    assert scene.codes() == ["TF201"]
    scene.send("/base", "base", static=True)
    assert scene.codes() == ["TF106", "TF201"], "a frame is its own parent with a slash, too"


REP105 = [
    ("the whole order", ["earth map", "map odom", "odom base_link"], []),
    ("without some frames", ["map base_link"], []),
    ("base_footprint above base_link", ["odom base_footprint", "base_footprint base_link"], []),
    ("base_footprint below base_link", ["odom base_link", "base_link base_footprint"], []),
    ("frames between", ["map x", "x odom", "odom y", "y base_link"], []),
    ("robots with prefixes", ["map a/odom", "a/odom a/base_link", "map b/odom", "b/odom b/base_link"], []),
    ("map below odom", ["odom map", "map base_link"], ["TF202"]),
    ("base_link beside odom", ["map odom", "map base_link"], ["TF202"]),
    ("base_link above all", ["base_link odom", "odom map"], ["TF202", "TF202"]),
    ("a robot's own order", ["a/base_link a/odom"], ["TF202"]),
    ("capitals", ["Map odom"], ["TF203"]),
    ("other marks", ["odom base-footprint"], ["TF203"]),
    ("other names", ["world robot_base_link", "world base_laser_link", "world mapper"], []),
]


def test_names_of_rep_105() -> None:
    failures = []
    for what, edges, expected in REP105:
        scene = Scene()
        for names in edges:
            scene.send(*names.split(), static=True)
        if (codes := scene.codes()) != expected:
            failures.append((what, codes))
    assert failures == []


def test_limits_of_values() -> None:
    jumping = Scene()
    for step in range(50):
        jumping.send("map", "base", step * 0.02, x=step * 0.001 + 2.0 * (step >= 25))
    assert jumping.codes() == ["TF303"]
    assert jumping.codes(max_jump_m=2.5) == []
    assert jumping.codes(max_speed_m_s=200.0) == []
    turning = Scene()
    for step in range(50):
        turning.send("map", "base", step * 0.02, yaw=math.radians(90) * (step >= 25), x=step * 0.001)
    assert turning.codes() == ["TF303"]
    assert turning.codes(max_turn_deg=100.0) == []


def test_steps_that_are_all_alike_are_no_teleports() -> None:
    spinning, driving, alternating = Scene(), Scene(), Scene()
    for step in range(50):
        spinning.send("map", "base", step * 0.02, yaw=math.radians(72) * step, x=step * 0.001)
        driving.send("map", "base", step * 0.1, x=step * 3.0)
        alternating.send("map", "base", step * 0.02, x=3.0 * (step % 2))
    assert spinning.codes() == [], "a lidar turns by 72 degrees in 20 ms"
    assert driving.codes() == [], "a car drives 30 m/s"
    assert alternating.codes() == ["TF303"], "nothing drives 150 m/s"
    driving.send("map", "base", 5.0, x=50 * 3.0 + 20.0)
    assert driving.codes() == ["TF303"]
    driving = Scene()
    for step in (*range(20), *range(24, 50)):
        driving.send("map", "base", step * 0.1, x=step * 3.0)
    assert driving.codes() == [], "lost messages make long steps, and no faster ones"


def test_static_transforms_may_be_set_again_once() -> None:
    scene = Scene()
    for x, expected in ((1.0, []), (1.0, []), (1.5, []), (2.0, ["TF502"])):
        scene.send("base", "camera", x=x, static=True)
        assert scene.codes() == expected


def test_fixed_transforms_on_tf_need_some_time() -> None:
    scene = Scene()
    scene.steadily("base", "camera", 40, x=1.0)
    assert scene.codes() == []
    scene.steadily("base", "lidar", 60, x=1.0)
    assert scene.codes(max_gap_s=10.0) == ["TF501"]


def test_limits_of_stamps() -> None:
    early = Scene()
    early.steadily("map", "base", late_s=-0.2)
    assert early.codes() == ["TF402"]
    assert early.codes(max_ahead_s=0.3) == []
    assert early.codes(max_skew_s=0.1) == ["TF402", "TF403"]
    late = Scene()
    late.steadily("map", "base", late_s=0.4)
    assert late.codes(max_skew_s=0.5) == []
    assert late.codes(max_skew_s=0.3) == ["TF403"]
    assert "0.400 s behind now" in late.findings(max_skew_s=0.3)[0].summary


def test_publishers_of_another_time_are_compared_with_each_other() -> None:
    scene = Scene(is_live=False)
    for step in range(50):
        for node, child, behind_s in (("a", "x", 0.0), ("b", "y", 0.0), ("c", "z", 3.0)):
            scene.send("map", child, step * 0.02 - behind_s, node=node, late_s=1e8 + behind_s)
    assert scene.codes() == ["TF403"]
    assert scene.findings()[0].frames == ["z"]
    assert "3.000 s behind those of the others" in scene.findings()[0].summary


def test_old_transforms_and_jumps() -> None:
    scene = Scene()
    scene.steadily("map", "base")
    scene.send("map", "base", -20.0, late_s=21.0)
    assert scene.codes() == ["TF407"]
    for step in range(5):
        scene.send("map", "base", -19.0 + step * 0.02, late_s=20.0 + step * 0.02)
    finding = scene.findings()[0]
    assert finding.code == "TF408"
    assert "20.980 s" in finding.evidence[0].text
    beside = Scene()
    for step in range(50):
        beside.send("map", "base", step * 0.02 + 60.0, node="fast", late_s=-59.9)
        beside.send("map", "base", step * 0.02, node="right", late_s=0.11)
    [old] = [finding for finding in beside.findings() if finding.code == "TF407"]
    assert old.sources[0].node == "/right"
    assert old.evidence[0].text.endswith("older than the newest, which is from /fast on /tf")
    swapped = Scene()
    for place, step in enumerate((0, 2, 1, 4, 3, 6, 5, 8, 7, 10, 9)):
        swapped.send("map", "base", step * 0.02, late_s=0.05 + (place - step) * 0.02)
    assert swapped.codes() == [], "two that changed places are no jump"


def test_rates_and_gaps() -> None:
    rare = Scene()
    rare.steadily("map", "base", 6, 0.3)
    assert rare.codes() == ["TF404"]
    assert rare.codes(min_rate_hz=3.0) == []
    single = Scene()
    single.steadily("map", "base", 100)
    single.send("map", "arm", 0.0)
    single.send("map", "late", 1.98)
    assert single.codes() == ["TF404"]
    assert single.findings()[0].frames == ["arm"], "one that came at the end may be quick"
    gone = Scene()
    gone.steadily("map", "base", 50)
    gone.steadily("map", "arm", 100)
    assert gone.codes() == ["TF406"]
    assert "until the end" in gone.findings()[0].evidence[0].text
    assert gone.codes(max_gap_s=1.1) == []


def test_jitter_is_not_one_pause() -> None:
    paused, uneven = Scene(), Scene()
    for step in range(50):
        paused.send("map", "base", step * 0.02 + 0.4 * (step > 25))
        uneven.send("map", "base", step * 0.04 + 0.036 * (step % 2))
    assert paused.codes() == []
    assert uneven.codes() == ["TF405"]
    assert uneven.codes(max_jitter=1.0) == []


NUMBERS = count(1)


def end(node: str, topic: str, qos: QoS, *, is_writer: bool) -> EndpointInfo:
    gid = next(NUMBERS).to_bytes(16, "big")
    return EndpointInfo(
        Topic(topic, "tf2_msgs/msg/TFMessage", ""), NodeName("/", node), is_writer, gid, qos.resolved()
    )


LATCHED = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL)
LOSSY = QoS(ReliabilityPolicy.BEST_EFFORT)
QUALITIES = [
    ("tf2's own", "/tf", [QoS()], [QoS(), LOSSY], []),
    ("tf2's own, static", "/tf_static", [LATCHED], [LATCHED], []),
    ("a lossy publisher with a lossy subscription", "/tf", [LOSSY], [LOSSY], ["TF504"]),
    ("a lossy publisher", "/tf", [LOSSY], [QoS(), LOSSY], ["TF503"]),
    ("a volatile static publisher that nobody reads", "/tf_static", [QoS()], [], ["TF504"]),
    ("a volatile and lossy static publisher", "/tf_static", [LOSSY], [LATCHED], ["TF503", "TF503"]),
    ("a volatile static subscription", "/tf_static", [LATCHED], [QoS()], ["TF504"]),
    ("a subscription to /tf that wants former ones", "/tf", [QoS()], [LATCHED], ["TF503"]),
]


def test_qualities_of_service() -> None:
    failures = []
    for what, topic, offered, requested, expected in QUALITIES:
        scene = Scene()
        scene.send("map", "base", static=True)
        scene.endpoints = [end("publisher", topic, qos, is_writer=True) for qos in offered]
        scene.endpoints += [end("subscription", topic, qos, is_writer=False) for qos in requested]
        if (codes := scene.codes()) != expected:
            failures.append((what, codes))
    assert failures == []


def test_recordings_name_topics() -> None:
    scene = Scene(is_live=False)
    scene.send("base", "base")
    [finding] = [finding for finding in scene.findings() if finding.code == "TF106"]
    assert finding.as_dict()["nodes"] == []
    scene.send("map", "base", x=math.nan)
    assert any("nan" not in finding.summary for finding in scene.findings())


@pytest.mark.parametrize(
    ("frame", "hint"), [("bse", "; did you mean base?"), ("/base", "; did you mean base?"), ("q", "")]
)
def test_unknown_frames_in_headers(frame: str, hint: str) -> None:
    scene = Scene()
    scene.send("map", "base", static=True)
    scene.headers = [
        FrameUse(used_frame, Source("/camera", "/image", "00"), 7)
        for used_frame in ("base", "map", "", frame)
    ]
    [finding] = scene.findings()
    assert (finding.code, finding.frames) == ("TF601", [frame])
    assert finding.evidence[0].text == f"7 messages{hint}"


def test_the_start_is_where_tests_expect_it() -> None:
    assert Scene().subject().times_ns[0] == START_S * S


def test_rates_of_a_simulation_are_those_of_its_own_time() -> None:
    slow = Scene()
    for step in range(20):
        slow.send("map", "base", 0.034 * step, late_s=0.3 * step)
    assert "TF404" in codes_of(slow.subject())
    assert codes_of(replace(slow.subject(), is_simulated=True)).isdisjoint({"TF404", "TF405", "TF406"})
    fast = Scene()
    for step in range(20):
        fast.send("map", "base", 0.6 * step, late_s=20.0 - 0.59 * step)
    assert codes_of(replace(fast.subject(), is_simulated=True)) & {"TF404", "TF405", "TF406"} == {"TF404"}


def codes_of(subject: Subject) -> set[str]:
    """Return the codes of the findings on a subject."""
    return {finding.code for finding in diagnose(subject)}
