"""QoS profiles in bags, which may be damaged or hostile."""

from __future__ import annotations

from pathlib import Path

import pytest

from tfloom.bag import BagError, Topic
from tfloom.bag.qos_profiles import DEPTH_MAX, offered, parse_profiles, read_overrides


@pytest.mark.parametrize("depth", ["-1", "2147483648", "1e400", ".inf", ".nan", "deep"])
def test_profile_with_a_depth_that_is_none_is_left_out(depth: str, tmp_path: Path) -> None:
    assert [profile.depth for profile in parse_profiles(f"- depth: {depth}\n- depth: 3")] == [3]
    path = tmp_path / "overrides.yaml"
    path.write_text(f"/tf: {{depth: {depth}}}", "utf-8")
    with pytest.raises(BagError, match="the profile of /tf has an unknown value"):
        read_overrides(path)


@pytest.mark.parametrize("duration", ["{sec: 1}", "{nsec: 1}"])
def test_duration_needs_both_parts(duration: str, tmp_path: Path) -> None:
    assert (
        parse_profiles(f"- deadline: {duration}\n- deadline: {{sec: 1, nsec: 2}}")[0].deadline_ns
        == 1_000_000_002
    )
    path = tmp_path / "overrides.yaml"
    path.write_text(f"/tf: {{deadline: {duration}}}", "utf-8")
    with pytest.raises(BagError, match="a duration in the profile of /tf needs both sec and nsec"):
        read_overrides(path)


def test_depth_that_is_offered_fits_the_wire() -> None:
    profiles = "- depth: 2147483647\n" * 3
    assert offered(Topic("/tf", "tf2_msgs/msg/TFMessage", offered_qos=profiles)).depth == DEPTH_MAX
