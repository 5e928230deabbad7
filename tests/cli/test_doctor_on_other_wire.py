"""`doctor` names programs of this machine on another wire, which can't be heard."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from tests.conftest import Program
from tests.zenoh_ports import NEEDS_ZENOH, use_port_of

from tfloom.cli.doctor.finding import Verdict
from tfloom.cli.doctor.wires import check_other_wire
from tfloom.rmw.cyclone import ports as cyclone_ports
from tfloom.rmw.cyclone.config import discovery_port

pytestmark = NEEDS_ZENOH
TALKER = ("tfloom", "run", "demo_nodes_py", "talker")


@pytest.fixture(autouse=True)
def zenoh_port(domain_id: int) -> Iterator[int]:
    with use_port_of(domain_id) as port:
        yield port


def test_programs_on_zenoh_are_named_on_dds(
    zenoh_port: int, monkeypatch: pytest.MonkeyPatch, start_program: Callable[..., Program]
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_cyclonedds_cpp")
    assert check_other_wire()[:2] == (Verdict.OK, f"no router of Zenoh on this machine, at port {zenoh_port}")
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    program = start_program(*TALKER)
    program.wait_for("Publishing")
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_cyclonedds_cpp")
    finding = check_other_wire()
    assert finding.verdict is Verdict.WARNING
    assert f"at port {zenoh_port}" in finding.summary
    assert "aren't heard on DDS" in finding.summary
    assert "RMW_IMPLEMENTATION" in finding.advice


def test_programs_on_dds_are_named_on_zenoh(
    domain_id: int, monkeypatch: pytest.MonkeyPatch, start_program: Callable[..., Program]
) -> None:
    if cyclone_ports.bound_udp_ports() is None:
        pytest.skip("this system doesn't tell which ports are bound")
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    assert check_other_wire()[:2] == (Verdict.OK, f"no program on DDS on this machine, in domain {domain_id}")
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_cyclonedds_cpp")
    program = start_program(*TALKER)
    program.wait_for("Publishing")
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    finding = check_other_wire()
    assert finding.verdict is Verdict.WARNING
    assert (
        finding.summary
        == f"programs on DDS are on this machine, in domain {domain_id}: they aren't heard on Zenoh"
    )
    assert str(discovery_port(domain_id, 0)) in finding.details["UDP ports of discovery"]


def test_invalid_settings_and_systems_that_do_not_tell(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_cyclonedds_cpp")
    monkeypatch.setenv("TFLOOM_ZENOH_PORT", "many")
    assert check_other_wire().verdict is Verdict.FAILED
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    assert check_other_wire().verdict is Verdict.OK
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    monkeypatch.setattr(cyclone_ports, "bound_udp_ports", lambda: None)
    assert check_other_wire()[:2] == (Verdict.OK, "programs on DDS are not looked for on this system")
