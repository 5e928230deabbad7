"""`tfloom tf doctor` as a process over DDS: each fault by its code and its nodes, and a sound tree without findings."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from tests.tf2_tools.diagnosis.faulty_nodes import FAULTS

from tfloom.tf2_tools.diagnosis.catalogue import KINDS

NODES = Path(__file__).with_name("faulty_nodes.py")
DOCTOR = ("tfloom", "tf", "doctor", "--json", "--topics")
LISTENING_S = 2.6
"""Longer than the period of the slowest fault, of 2 s, on a busy machine, too."""
BUSY = ("--max-gap", "0.75", "--max-ahead", "0.5")
"""Limits for a machine on which other tests run, too: the gap among the faults is 1 s long."""


class Expected(NamedTuple):
    """The findings of a fault: their codes, and the nodes that each names."""

    codes: set[str]
    suffixes: tuple[str, ...] = ("",)
    """What follows the fault's name in the names of its nodes."""


EXPECTED = {
    "several_publishers": Expected({"TF101"}, ("_a", "_b")),
    "static_and_dynamic": Expected({"TF102"}, ("_joint", "_mounting")),
    "reparenting": Expected({"TF103"}),
    "loop": Expected({"TF104"}),
    "disconnected": Expected({"TF105"}),
    "self_transform": Expected({"TF106"}),
    "empty_frame_id": Expected({"TF107"}),
    "leading_slash": Expected({"TF201"}),
    "rep105_order": Expected({"TF202"}),
    "rep105_name": Expected({"TF203"}),
    "not_finite": Expected({"TF301"}),
    "not_unit": Expected({"TF302"}),
    "teleport": Expected({"TF303"}),
    "zero_stamps": Expected({"TF401"}),
    "ahead": Expected({"TF402"}),
    "skew": Expected({"TF403"}),
    "low_rate": Expected({"TF404"}),
    "jitter": Expected({"TF405"}),
    "gap": Expected({"TF406"}),
    "old_data": Expected({"TF407"}),
    "time_jump": Expected({"TF408"}),
    "static_on_tf": Expected({"TF501"}),
    "dynamic_on_tf_static": Expected({"TF502"}),
    "volatile_static": Expected({"TF503"}),
    "best_effort": Expected({"TF503"}),
    "volatile_reader": Expected({"TF504"}),
    "unreadable": Expected({"TF505"}),
    "other_type": Expected({"TF506"}),
    "unknown_header": Expected({"TF601"}),
}
NO_LIVE_FAULT = {
    "TF108",  # `test_an_empty_graph`
    "TF204",  # test_checks.py
    "TF602",  # test_requests.py
}
"""The codes whose tests are elsewhere."""


def names_of(findings: list[dict[str, Any]], fault: str) -> dict[str, set[str]]:
    """Return the nodes of a fault that findings name, by code."""
    nodes = {f"/faults/{fault}{suffix}" for suffix in EXPECTED[fault].suffixes}
    found: dict[str, set[str]] = {}
    for finding in findings:
        if named := nodes & set(finding["nodes"]):
            found.setdefault(finding["code"], set()).update(named)
    return found


def expected_names(fault: str) -> dict[str, set[str]]:
    nodes = {f"/faults/{fault}{suffix}" for suffix in EXPECTED[fault].suffixes}
    return dict.fromkeys(EXPECTED[fault].codes, nodes)


def run_doctor(
    start: Callable[..., Any], *words: str, code: int, seconds: float = LISTENING_S
) -> dict[str, Any]:
    """Run the doctor, and return its report; fail the test if its exit code is another one."""
    program = start(*DOCTOR, "--seconds", f"{seconds}", *BUSY, *words)
    assert program.wait() == code, program.output
    report: dict[str, Any] = json.loads(program.output)
    return report


def start_nodes(start: Callable[..., Any], *faults: str) -> Any:
    program = start("python", NODES, *faults, stdin=subprocess.PIPE)
    program.wait_for("ready")
    return program


@pytest.fixture(scope="module")
def findings(module_domain_id: int, start_module_program: Callable[..., Any]) -> list[dict[str, Any]]:
    """Return the findings on a graph that has all the faults.

    Without those of uneven periods of other nodes: where the machine pauses their process, they are true.
    """
    start_nodes(start_module_program)
    found: list[dict[str, Any]] = run_doctor(start_module_program, code=1)["findings"]
    uneven = {f"/faults/{fault}" for fault, expected in EXPECTED.items() if "TF405" in expected.codes}
    return [finding for finding in found if finding["code"] != "TF405" or uneven & set(finding["nodes"])]


def test_each_code_has_a_fault() -> None:
    assert set(EXPECTED) == set(FAULTS)
    assert {code for fault in EXPECTED.values() for code in fault.codes} | NO_LIVE_FAULT == set(KINDS)


@pytest.mark.parametrize("fault", EXPECTED)
def test_a_fault_among_all_is_named(fault: str, findings: list[dict[str, Any]]) -> None:
    assert names_of(findings, fault) == expected_names(fault)


def test_sound_nodes_among_the_faulty_are_not_named(findings: list[dict[str, Any]]) -> None:
    named = {node for finding in findings for node in finding["nodes"]}
    assert not {"/faults/clean", "/faults/trunk"} & named
    blaming = {finding["code"] for finding in findings if "/faults/listener" in finding["nodes"]}
    assert blaming == {"TF503"}, "the listener is named only as what a publisher does not connect with"


@pytest.mark.slow
@pytest.mark.parametrize("fault", EXPECTED)
def test_a_fault_alone_has_no_other_finding(
    fault: str, domain_id: int, start_program: Callable[..., Any]
) -> None:
    start_nodes(start_program, fault)
    is_error = any(KINDS[code].severity.value == "error" for code in EXPECTED[fault].codes)
    report = run_doctor(start_program, code=int(is_error))
    assert {finding["code"] for finding in report["findings"]} == EXPECTED[fault].codes
    assert names_of(report["findings"], fault) == expected_names(fault)


def test_a_sound_tree_has_no_findings(domain_id: int, start_program: Callable[..., Any]) -> None:
    start_nodes(start_program, "none")
    report = run_doctor(start_program, "--strict", code=0, seconds=1.2)
    assert report["findings"] == []
    assert (report["frames"], report["roots"]) == (6, ["world"])


def test_an_empty_graph(domain_id: int, start_program: Callable[..., Any]) -> None:
    program = start_program("tfloom", "tf", "doctor", "--seconds", "0.3")
    assert program.wait() == 1
    listened = re.match(r"the graph, (\d+\.\d) s: ", program.output)
    assert listened
    assert float(listened[1]) >= 0.3  # longer on a busy machine
    told = f"TF108 error: no transform came within {listened[1]} s and there is no publisher"
    assert told in program.output
