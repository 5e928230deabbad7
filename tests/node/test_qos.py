"""QoS profiles, and their conversion for the wire."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from tfloom.node.qos.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    InvalidQoSProfileException,
    LivelinessPolicy,
    QoSCompatibility,
    QoSPresetProfiles,
    QoSProfile,
    ReliabilityPolicy,
    qos_check_compatible,
    qos_profile_action_status_default,
    qos_profile_best_available,
    qos_profile_parameter_events,
    qos_profile_rosout_default,
    qos_profile_sensor_data,
    qos_profile_system_default,
    qos_profile_unknown,
)
from tfloom.node.values.duration import Duration, Infinite
from tfloom.rmw import qos as wire


def test_default_profile_values() -> None:
    profile = QoSProfile(depth=10)
    assert profile.history is HistoryPolicy.KEEP_LAST
    assert profile.reliability is ReliabilityPolicy.RELIABLE
    assert profile.durability is DurabilityPolicy.VOLATILE
    assert profile.liveliness is LivelinessPolicy.SYSTEM_DEFAULT
    assert profile.deadline == profile.lifespan == profile.liveliness_lease_duration == Duration()
    assert profile.to_wire() == wire.QoS(depth=10)


def test_keep_last_requires_a_depth() -> None:
    with pytest.raises(InvalidQoSProfileException, match="History and/or depth settings are required"):
        QoSProfile()
    with pytest.raises(InvalidQoSProfileException, match="KEEP_LAST without a depth"):
        QoSProfile(history=HistoryPolicy.KEEP_LAST)
    assert QoSProfile(history=HistoryPolicy.KEEP_ALL).to_wire().history == wire.HistoryPolicy.KEEP_ALL


@pytest.mark.parametrize(
    ("field", "value", "error"),
    [
        ("depth", -1, ValueError),
        ("depth", 1.0, TypeError),
        ("depth", True, TypeError),
        ("lifespan", 5, TypeError),
        ("reliability", 17, ValueError),
        ("nonsense", 1, TypeError),
        ("avoid_ros_namespace_conventions", 1, TypeError),
    ],
)
def test_invalid_values_name_their_field(field: str, value: object, error: type[Exception]) -> None:
    with pytest.raises(error, match=field):
        QoSProfile(**{"depth": 1, field: value})


def test_profile_converts_to_the_wire() -> None:
    profile = QoSProfile(
        depth=3,
        reliability=2,
        durability=DurabilityPolicy.TRANSIENT_LOCAL,
        deadline=Duration(seconds=1),
        lifespan=Infinite,
    )
    assert profile.to_wire() == wire.QoS(
        wire.ReliabilityPolicy.BEST_EFFORT,
        wire.DurabilityPolicy.TRANSIENT_LOCAL,
        depth=3,
        deadline_ns=10**9,
    )
    assert QoSProfile.from_wire(profile.to_wire()).deadline == Duration(seconds=1)
    with pytest.raises(InvalidQoSProfileException, match="UNKNOWN"):
        qos_profile_unknown.to_wire()


def test_presets_match_those_of_a_real_ros() -> None:
    assert qos_profile_rosout_default.to_wire() == wire.QoS(
        durability=wire.DurabilityPolicy.TRANSIENT_LOCAL, depth=1000, lifespan_ns=10 * 10**9
    )
    assert qos_profile_parameter_events.to_wire() == wire.QoS(depth=1000)
    assert qos_profile_sensor_data.to_wire() == wire.QoS(wire.ReliabilityPolicy.BEST_EFFORT, depth=5)
    assert qos_profile_action_status_default.to_wire().durability == wire.DurabilityPolicy.TRANSIENT_LOCAL
    assert qos_profile_system_default.to_wire() == wire.QoS(depth=0)
    assert qos_profile_system_default.to_wire().resolved() == wire.QoS(depth=1)


def test_presets_and_policies_have_short_names() -> None:
    assert ReliabilityPolicy.get_from_short_key("best_effort") is ReliabilityPolicy.BEST_EFFORT
    assert HistoryPolicy.KEEP_ALL.short_key == "keep_all"
    assert "transient_local" in DurabilityPolicy.short_keys()
    assert QoSPresetProfiles.get_from_short_key("sensor_data") is qos_profile_sensor_data
    assert QoSPresetProfiles.SENSOR_DATA.value is qos_profile_sensor_data


GOLDEN = Path(__file__).parents[1] / "golden" / "qos_compatible_jazzy.json"
"""Recorded from a real rclpy 7.1: fields of the publisher's profile and of the subscription's, verdict, reasons."""
POLICIES = {
    "history": HistoryPolicy,
    "reliability": ReliabilityPolicy,
    "durability": DurabilityPolicy,
    "liveliness": LivelinessPolicy,
}


def profile_of(fields: dict[str, str | int]) -> QoSProfile:
    values = {
        name: POLICIES[name][value] if name in POLICIES else Duration(nanoseconds=value)
        for name, value in fields.items()
    }
    return QoSProfile(**{"depth": 1, **values})


def test_compatibility_is_as_recorded() -> None:
    rows = json.loads(GOLDEN.read_text("utf-8"))
    assert {verdict for _, _, verdict, _ in rows} == {"OK", "WARNING", "ERROR"}
    for offered, requested, verdict, reasons in rows:
        answer = qos_check_compatible(profile_of(offered), profile_of(requested))
        assert answer == (QoSCompatibility[verdict], reasons), (offered, requested)


def test_best_available_durations_are_compatible(deviations: dict[str, dict[str, str]]) -> None:
    assert "qos-best-available" in deviations
    for profile in (QoSProfile(depth=1, deadline=Duration(seconds=1)), qos_profile_sensor_data):
        assert "deadline" not in qos_check_compatible(profile, qos_profile_best_available)[1]
        assert "deadline" not in qos_check_compatible(qos_profile_best_available, profile)[1]


@pytest.mark.parametrize(
    "make", [lambda: QoSProfile(depth=0), lambda: setattr(QoSProfile(depth=1), "depth", 0)]
)
def test_depth_of_zero_warns_at_the_line_of_the_caller(make: Callable[[], object]) -> None:
    text = (
        "A zero depth with KEEP_LAST doesn't make sense; no data could be stored. "
        "This will be interpreted as SYSTEM_DEFAULT"
    )
    with pytest.warns(UserWarning, match=f"^{text}$") as caught:
        make()
    assert [warning.filename for warning in caught] == [__file__]


def test_depth_of_zero_is_allowed_without_keep_last() -> None:
    assert QoSProfile(history=HistoryPolicy.KEEP_ALL, depth=0).depth == 0
    assert QoSProfile(history=HistoryPolicy.SYSTEM_DEFAULT, depth=0).depth == 0
    assert QoSProfile.from_wire(wire.QoS(depth=0)).depth == 0  # as a peer announces it
