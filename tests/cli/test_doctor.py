"""`doctor`: its findings, and its exit code."""

from __future__ import annotations

import json
import os
import re
import sys
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
import transcript
from tests.zenoh_ports import use_port_of

from tfloom.cli.doctor import checks as health
from tfloom.cli.doctor.checks import Interface, check_domain, check_network, check_reach
from tfloom.cli.doctor.finding import Verdict
from tfloom.cli.shared import graph
from tfloom.interfaces.std_msgs.msg import Empty
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName
from tfloom.rmw.qos import QoS, ReliabilityPolicy
from tfloom.rmw.typed_names import service_of, topic_of
from tfloom.ros_imports import ros_distro

LO, ETH0, TUN0 = Interface("lo", 0x9), Interface("eth0", 0x1003), Interface("tun0", 0x1)


def doctor_here(*flags: str, **environment: str) -> transcript.Transcript:
    with pytest.MonkeyPatch.context() as patch:
        for name, value in environment.items():
            patch.setenv(name, value)
        return transcript.run_here("doctor", *flags)


def findings(*flags: str, **environment: str) -> tuple[dict[str, dict[str, object]], int]:
    """Return the findings by their check, and the exit code; a process finds what another PYTHONPATH holds."""
    if "PYTHONPATH" in environment:
        answer = transcript.run("doctor", "--json", *flags, env={**os.environ, **environment})
    else:
        answer = doctor_here("--json", *flags, **environment)
    return {finding["check"]: finding for finding in json.loads(answer.text)}, answer.exit_code


def test_all_checks_pass_on_a_sound_system(domain_id: int) -> None:
    with use_port_of(domain_id):  # a router at Zenoh's own port, of somebody else, would be a warning
        answer = transcript.run("doctor")
    assert answer.exit_code == 0, answer.text
    assert "domain: domain %d, discovery range LOCALHOST" % domain_id in answer.text  # noqa: UP031
    assert "and exchanged a message" in answer.text
    is_zenoh = os.environ.get("RMW_IMPLEMENTATION") == "rmw_zenoh_cpp"  # whose router is a check more
    assert answer.text.endswith(f"\nAll {15 if is_zenoh else 14} checks passed")


def test_wtf_is_doctor() -> None:
    answers = [transcript.run_here(word, "--help") for word in ("wtf", "doctor")]
    assert answers[0].exit_code == 0, answers[0].text
    assert answers[0].text == answers[1].text
    assert "--report-failed" in answers[0].text


@pytest.mark.parametrize(
    ("environment", "check"),
    [
        ({"RMW_IMPLEMENTATION": "rmw_none"}, "wire"),
        ({"ROS_DOMAIN_ID": "300"}, "domain"),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "NEAR"}, "domain"),
    ],
)
def test_invalid_setting_is_a_failure(environment: dict[str, str], check: str) -> None:
    found, exit_code = findings(**environment)
    assert exit_code == 1
    assert found[check]["verdict"] == "failed"
    assert found[check]["summary"]


def test_mixture_with_a_real_ros_is_a_failure(tmp_path: Path) -> None:
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").write_text("")
    found, exit_code = findings(PYTHONPATH=str(tmp_path), RMW_IMPLEMENTATION="tfloom_local")
    assert exit_code == 1
    assert found["names"]["verdict"] == "failed"
    assert f"rclpy from {tmp_path}" in str(found["names"]["summary"])
    assert "names" not in findings("-ep", RMW_IMPLEMENTATION="tfloom_local")[0]


def test_package_of_a_workspace_that_precedes_ours_is_a_warning_that_names_it(tmp_path: Path) -> None:
    (tmp_path / "ros2cli").mkdir()
    (tmp_path / "ros2cli" / "__init__.py").write_text("")
    found, exit_code = findings(PYTHONPATH=str(tmp_path), RMW_IMPLEMENTATION="tfloom_local")
    assert exit_code == 0
    assert found["names"]["verdict"] == "warning"
    assert str(found["names"]["summary"]).startswith(f"what precedes tfloom's own: ros2cli from {tmp_path}")


@pytest.mark.wire
def test_library_that_is_passed_over_is_a_warning_with_the_reason(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.delenv("RMW_IMPLEMENTATION", raising=False)
    monkeypatch.setenv("TFLOOM_LIBDDSC", str(tmp_path / "none.so"))
    finding = health.check_wire()
    assert finding.verdict is Verdict.WARNING
    assert re.fullmatch(r"rmw_cyclonedds_cpp, the default; libddsc [\d.]+ of .+", finding.summary)
    assert finding.advice.startswith("the DDS library of TFLOOM_LIBDDSC can't be used: cannot open")
    assert str(tmp_path / "none.so") in finding.advice


def test_distribution_that_shadows_a_package_of_ours_is_named(tmp_path: Path) -> None:
    (tmp_path / "cv_bridge").mkdir()
    (tmp_path / "cv_bridge" / "__init__.py").touch()
    info = tmp_path / "cv_bridge-1.13.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: cv-bridge\nVersion: 1.13\n")
    (info / "top_level.txt").write_text("cv_bridge\n")
    found, exit_code = findings(PYTHONPATH=str(tmp_path), RMW_IMPLEMENTATION="tfloom_local")
    assert (found["names"]["verdict"], exit_code) == ("warning", 0)
    text = "cv_bridge is that of the distribution cv-bridge, which takes precedence over tfloom's"
    assert found["names"]["summary"] == text
    assert found["names"]["advice"] == "pip uninstall cv-bridge"


@pytest.mark.parametrize(
    ("given", "verdict", "text"),
    [
        (
            "kilted",
            "ok",
            "kilted is followed where ROS 2's distributions contradict each other: by ROS_DISTRO",
        ),
        (
            "",
            "ok",
            "jazzy is followed where ROS 2's distributions contradict each other: ROS_DISTRO is not set",
        ),
        ("humble", "warning", "ROS_DISTRO is humble, which tfloom does not know; jazzy is followed"),
        ("rolling", "warning", "ROS_DISTRO is rolling, which tfloom does not know; lyrical is followed"),
        ("\x1b[2Jx", "warning", "ROS_DISTRO is \\x1b[2Jx, which tfloom does not know; jazzy is followed"),
    ],
)
def test_distribution_that_is_followed_is_named(
    given: str, verdict: str, text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_DISTRO", given)
    monkeypatch.setattr(ros_distro, "ROS_DISTRO", ros_distro.nearest(given))
    finding = health.CHECKS["distribution"]()
    assert (finding.verdict.value, finding.details["followed"]) == (verdict, ros_distro.ROS_DISTRO)
    assert finding.summary.startswith(text)


def test_real_ros2_command_on_the_path_is_a_warning(tmp_path: Path) -> None:
    command = tmp_path / "ros2"
    command.touch(mode=0o755)
    environment = {
        "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}",
        "RMW_IMPLEMENTATION": "tfloom_local",
    }
    found, exit_code = findings(**environment)
    assert (found["commands"]["verdict"], exit_code) == ("warning", 0)
    assert str(command) in str(found["commands"])
    assert findings("--include-warnings", **environment)[1] == 1


def test_report_flags_print_details() -> None:
    environment = {"RMW_IMPLEMENTATION": "tfloom_local", "ROS_DOMAIN_ID": "x"}
    whole = doctor_here("--report", **environment)
    failed = doctor_here("--report-failed", **environment)
    assert "reportlab: " in whole.text
    assert "reportlab: " not in failed.text
    assert "ROS_DOMAIN_ID: x" in failed.text
    assert failed.text.endswith(
        "5/14 checks failed\nFailed: domain, round trip, peers, quality of service, services"
    )
    assert whole.exit_code == failed.exit_code == 1


OFFERED = "/chatter: /talker and /listener: offered RELIABILITY BEST_EFFORT, requested RELIABILITY RELIABLE"


def test_publishers_and_subscriptions_that_do_not_connect_are_named(domain_id: int) -> None:
    best_effort = QoS(reliability=ReliabilityPolicy.BEST_EFFORT)
    topic, other = topic_of(Empty, "/chatter"), topic_of(Empty, "/scan")
    talker, listener = NodeName("/", "talker"), NodeName("/", "listener")
    participant = open_participant()
    try:
        for node in (talker, listener):
            participant.add_node(node)
        participant.create_writer(talker, topic, best_effort)
        participant.create_reader(listener, other, QoS())
        participant.create_reader(listener, topic, QoS())
        participant.create_reader(talker, topic, best_effort)
        answer = doctor_here("--report")
        participant.create_writer(talker, other, best_effort)
        both = doctor_here("--report-failed")
    finally:
        participant.close()
    passes = os.environ.get("RMW_IMPLEMENTATION") == "rmw_zenoh_cpp"
    assert answer.exit_code == int(not passes)
    assert f"  quality of service: {OFFERED}, so " in answer.text
    assert f"pair 1: {OFFERED}\n" in answer.text
    assert "pair 2" not in answer.text
    assert "; and 1 more pair: see --report" in both.text
    found = health.checks(exclude_packages=True)["quality of service"]()  # when they have left
    assert found.verdict is Verdict.OK, found


def test_services_and_those_without_a_server_are_listed(domain_id: int) -> None:
    participant = open_participant()
    node = NodeName("/", "both")
    try:
        participant.add_node(node)
        responder = participant.create_responder(node, service_of(SetBool, "/served"), QoS())
        requesters = [
            participant.create_requester(node, service_of(SetBool, name), QoS())
            for name in ("/served", "/missing")
        ]
        found = health.checks(exclude_packages=True)["services"]()
        for end in (responder, *requesters):
            end.close()
    finally:
        participant.close()
    assert found.verdict is Verdict.OK
    assert found.summary == (
        "services: 2, of which 0 begin goals of actions; clients wait for a server of /missing"
    )
    assert found.details == {
        "/served": "std_srvs/srv/SetBool; servers /both; clients /both",
        "/missing": "std_srvs/srv/SetBool; clients /both",
    }
    assert health.checks(exclude_packages=True)["services"]().details == {}


def test_link_to_our_own_command_is_ours(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`uv tool install` and pipx put such a link into ~/.local/bin."""
    (tmp_path / "venv").mkdir()
    (tmp_path / "bin").mkdir()
    (tmp_path / "venv" / "ros2").touch(mode=0o755)
    (tmp_path / "bin" / "ros2").symlink_to(tmp_path / "venv" / "ros2")
    monkeypatch.setattr(sys, "executable", str(tmp_path / "venv" / "python"))
    monkeypatch.setenv("PATH", str(tmp_path / "bin"))
    assert health.check_commands().verdict is Verdict.OK
    (tmp_path / "bin" / "ros2").unlink()
    (tmp_path / "bin" / "ros2").touch(mode=0o755)
    assert health.check_commands().verdict is Verdict.WARNING


def test_checks_of_the_domain_join_it_once_and_the_next_run_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.setenv("ROS_DOMAIN_ID", "1")
    joined: list[int] = []

    def open_counted() -> Any:
        joined.append(1)
        return open_participant()

    monkeypatch.setattr(graph, "open_participant", open_counted)
    for number in (1, 2):
        with closing(open_participant()) as other:
            other.add_node(NodeName("/", f"server{number}"))
            other.create_responder(
                NodeName("/", f"server{number}"), service_of(SetBool, f"/trigger{number}"), QoS()
            )
            chosen = health.checks()
            findings = {name: chosen[name]() for name in health.DOMAIN_CHECKS}
        assert all(finding.verdict is Verdict.OK for finding in findings.values())
        assert list(findings["services"].details) == [f"/trigger{number}"]
        assert len(joined) == number


def test_checks_for_other_programs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.setenv("ROS_DOMAIN_ID", "x")
    from ros2doctor.api import DoctorCheck, Report, Result, generate_reports, run_checks

    failed = {"domain", "round trip", "peers", "quality of service", "services"}
    assert run_checks() == (failed, 5, 14)
    assert run_checks(exclude_packages=True)[1:] == (5, 12)
    (report,) = generate_reports(categories=["domain"])
    assert isinstance(report, Report)
    assert report.name == "domain"
    assert ("verdict", "failed") in report.items
    assert ("ROS_DOMAIN_ID", "x") in report.items
    result = Result()
    result.add_error()
    result.add_warning()
    assert (result.error, result.warning) == (1, 1)
    with pytest.raises(NotImplementedError):
        DoctorCheck().check()


@pytest.mark.parametrize(
    ("words", "exit_code", "said"),
    [
        (("daemon", "status"), 0, "There is no daemon"),
        (("daemon", "start", "--debug"), 0, "There is no daemon"),
        (("security", "create_keystore", "keys", "--verbose"), 1, "SROS 2 is not there"),
        (("component", "types", "composition"), 1, "Components are C++"),
    ],
)
def test_unneeded_commands_print_an_explanation(words: tuple[str, ...], exit_code: int, said: str) -> None:
    answer = transcript.run_here(*words)
    assert answer.exit_code == exit_code
    assert answer.text.startswith(said)
    assert len(answer.text.splitlines()) == 1


@pytest.mark.parametrize(
    ("asked", "interfaces", "verdict", "said"),
    [
        ("LOCALHOST", [ETH0, LO], Verdict.OK, "eth0 (multicast), lo (no multicast); DDS uses lo, by unicast"),
        (
            "SUBNET",
            [ETH0, LO],
            Verdict.OK,
            "eth0 (multicast), lo (no multicast); DDS uses eth0, by multicast",
        ),
        (
            "SUBNET",
            [LO, TUN0],
            Verdict.WARNING,
            "tun0 (no multicast); none can discover other machines by multicast",
        ),
        (
            "SYSTEM_DEFAULT",
            [ETH0, LO],
            Verdict.OK,
            "interfaces that are up: eth0 (multicast), lo (no multicast)",
        ),
        ("NEAR", [ETH0], Verdict.OK, "interfaces that are up: eth0 (multicast)"),
        ("SUBNET", [], Verdict.OK, "interfaces that are up: not known on this system"),
    ],
)
@pytest.mark.usefixtures("reach")
def test_used_network_interface_is_reported(
    asked: str, interfaces: list[Interface], verdict: Verdict, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", asked)
    monkeypatch.setattr(health, "_interfaces", lambda: iter(interfaces))
    monkeypatch.setattr(health, "LARGE_BUFFER", 0)
    found = check_network()
    assert found.verdict is verdict
    assert found.summary.endswith(said)


def test_small_receive_buffer_is_reported_with_the_interfaces(monkeypatch: pytest.MonkeyPatch) -> None:
    if not Path("/proc/sys/net/core/rmem_max").is_file():
        pytest.skip("needs Linux's /proc")
    monkeypatch.setattr(health, "LARGE_BUFFER", 1 << 60)
    found = check_network()
    assert found.verdict is Verdict.WARNING
    assert found.summary.startswith("interfaces that are up: ")
    assert "bytes at most" in found.summary


@pytest.mark.parametrize(
    ("environment", "said"),
    [
        (
            {"ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET"},
            "discovery range SUBNET opens the UDP ports 17900 and 17901 and two UDP ports from 17910 on",
        ),
        (
            {"ROS_AUTOMATIC_DISCOVERY_RANGE": "SYSTEM_DEFAULT"},
            "discovery range SYSTEM_DEFAULT opens the UDP ports 17900 and 17901 and one that the system selects",
        ),
        (
            {"ROS_AUTOMATIC_DISCOVERY_RANGE": "SYSTEM_DEFAULT", "ROS_STATIC_PEERS": "192.0.2.1"},
            "discovery range SYSTEM_DEFAULT opens the UDP ports 17900 and 17901 and one that the system selects",
        ),
        ({"ROS_STATIC_PEERS": "192.0.2.1"}, "ROS_STATIC_PEERS opens two UDP ports from 17910 on"),
        ({"CYCLONEDDS_URI": "<CycloneDDS/>"}, "CYCLONEDDS_URI opens the UDP ports of its configuration"),
    ],
)
@pytest.mark.usefixtures("reach")
def test_what_is_open_to_other_machines_is_a_warning(
    environment: dict[str, str], said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", "42")
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    found = check_reach()
    assert found.verdict is Verdict.WARNING
    assert found.summary.startswith(f"{said}, on all interfaces: any machine that reaches them can read")
    assert "docs/security.md" in found.advice


@pytest.fixture
def reach(monkeypatch: pytest.MonkeyPatch) -> None:
    """Remove the variables that open sockets to other machines."""
    names = ("CYCLONEDDS_URI", "ROS_LOCALHOST_ONLY", "ROS_STATIC_PEERS", "RMW_IMPLEMENTATION")
    for name in (*names, "ROS_AUTOMATIC_DISCOVERY_RANGE", "ROS_SECURITY_ENABLE", "ROS_SECURITY_STRATEGY"):
        monkeypatch.delenv(name, raising=False)


@pytest.mark.skipif(sys.platform != "linux", reason="other systems bind sockets in other ways")
@pytest.mark.parametrize(
    ("asked", "said"), [("LOCALHOST", "the sockets are bound to loopback"), ("OFF", "no socket is open")]
)
def test_what_stays_on_this_machine_is_sound(
    asked: str, said: str, domain_id: int, reach: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    # After `domain_id`, which may name another wire than DDS.
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", asked)
    assert check_reach()[:2] == (Verdict.OK, f"within this machine: {said}")
    monkeypatch.setenv("ROS_SECURITY_ENABLE", "true")
    summary = f"{said}, but ROS_SECURITY_ENABLE has no effect: nothing is encrypted"
    assert check_reach()[:2] == (Verdict.WARNING, summary)


@pytest.mark.wire
@pytest.mark.usefixtures("reach")
def test_enforced_security_is_a_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_SECURITY_ENABLE", "true")
    monkeypatch.setenv("ROS_SECURITY_STRATEGY", "Enforce")
    found = check_reach()
    assert found.verdict is Verdict.FAILED
    assert found.summary.startswith(
        "ROS_SECURITY_STRATEGY is Enforce, but the wheels of cyclonedds are built"
    )


@pytest.mark.usefixtures("reach")
def test_the_wire_inside_a_process_reaches_nobody(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    assert check_reach()[:2] == (Verdict.OK, "tfloom_local stays inside one process")


def test_effective_discovery_range_is_reported() -> None:
    environment = {"ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET", "ROS_LOCALHOST_ONLY": "1", "CYCLONEDDS_URI": ""}
    found, _ = findings(RMW_IMPLEMENTATION="tfloom_local", **environment)
    assert str(found["domain"]["summary"]).endswith("discovery range LOCALHOST")
    found, _ = findings(
        RMW_IMPLEMENTATION="tfloom_local", ROS_AUTOMATIC_DISCOVERY_RANGE="OFF", CYCLONEDDS_URI=""
    )
    assert "discovery is off" in str(found["domain"]["advice"])


@pytest.mark.parametrize(
    ("variable", "value", "said"),
    [
        (
            "ROS_DISCOVERY_SERVER",
            "192.0.2.1:11811",
            "ROS_DISCOVERY_SERVER has no effect: tfloom uses no discovery server of Fast DDS",
        ),
        (
            "ROS_AUTOMATIC_DISCOVERY_RANGE",
            "OFF",
            "ROS_STATIC_PEERS is ignored, because the discovery range is OFF",
        ),
        ("ROS_LOCALHOST_ONLY", "1", "ROS_STATIC_PEERS is ignored, because ROS_LOCALHOST_ONLY is 1"),
    ],
)
@pytest.mark.usefixtures("reach")
def test_settings_of_discovery_without_an_effect_are_named(
    variable: str, value: str, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_STATIC_PEERS", "127.0.0.1")
    monkeypatch.setenv("ROS_DOMAIN_ID", "42")
    assert check_domain().verdict is Verdict.OK
    monkeypatch.setenv(variable, value)
    found = check_domain()
    assert found.verdict is Verdict.WARNING
    assert found.summary == f"domain 42; {said}"
    assert found.details[variable] == value
