"""QoS profiles, and their conversion for the wire."""

from __future__ import annotations

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
    assert qos_profile_system_default.to_wire() == wire.QoS(depth=1)


def test_presets_and_policies_have_short_names() -> None:
    assert ReliabilityPolicy.get_from_short_key("best_effort") is ReliabilityPolicy.BEST_EFFORT
    assert HistoryPolicy.KEEP_ALL.short_key == "keep_all"
    assert "transient_local" in DurabilityPolicy.short_keys()
    assert QoSPresetProfiles.get_from_short_key("sensor_data") is qos_profile_sensor_data
    assert QoSPresetProfiles.SENSOR_DATA.value is qos_profile_sensor_data


def test_compatibility_check_names_the_policies() -> None:
    assert qos_check_compatible(QoSProfile(depth=1), qos_profile_sensor_data) == (QoSCompatibility.OK, "")
    compatibility, reason = qos_check_compatible(qos_profile_sensor_data, qos_profile_action_status_default)
    assert compatibility is QoSCompatibility.ERROR
    assert "reliability" in reason
    assert "durability" in reason
