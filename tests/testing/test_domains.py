"""Domains that one process holds at a time."""

from __future__ import annotations

import sys

import pytest
from tests.conftest import run_to_end

from tfloom.rmw.cyclone import wire as cyclonedds
from tfloom.testing.domains import held_locks, hold_domain


def test_a_held_domain_is_given_to_nobody_else() -> None:
    with hold_domain() as domain:
        assert len(held_locks()) >= 1
        with (
            pytest.raises(TimeoutError, match="all DDS domains have been in use for 0 s"),
            hold_domain([domain], 0.0),
        ):
            pass
        code = f"from tfloom.testing.domains import hold_domain\nwith hold_domain([{domain}], 0.0): pass"
        other = run_to_end([sys.executable, "-c", code])
        assert "TimeoutError" in other.stderr
    with hold_domain([domain], 60.0) as again:
        assert again == domain


def test_domains_of_two_holders_differ() -> None:
    with hold_domain() as one, hold_domain() as two:
        assert one != two


@pytest.mark.wire
def test_a_participant_that_is_left_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
    left = []
    with (
        pytest.raises(RuntimeError, match=r"a participant is left on domain \d+: destroy it"),
        hold_domain() as domain,
    ):
        left.append(cyclonedds.open_participant(domain))
    left.pop().close()
    assert not cyclonedds.is_joined(domain)
