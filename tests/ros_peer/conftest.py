"""Nodes of tfloom and of the real rclpy on one domain, and the table of what passes between them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from tests.conftest import Program
from tools.ros_peer import JAZZY, KILTED, NoPeerError, Release, RosPeer, find

HERE = Path(__file__).parent
END = HERE / "programs" / "end.py"

OURS, THEIRS = "tfloom", "Fast DDS"
FROM_US, TO_US = f"{OURS} → {THEIRS}", f"{THEIRS} → {OURS}"
DIRECTIONS = (FROM_US, TO_US)

ROWS = (
    "QoS pairs",
    "late joiners",
    "transforms",
    "nodes, listed",
    "topics, listed with types and hashes",
    "listings in a row",
    "/clock",
    "1 MB and 8 MB, reliable",
    "1 MB and 8 MB, best effort",
    "20,000 messages at 1 kHz",
    "closed, and no longer counted",
    "killed, and returned",
    "services",
    "actions",
    "parameters",
)
"""The rows of the table, in order. One without a test is printed as not run, so that it is not forgotten."""

ALSO_BESIDE_KILTED = {
    "test_content_filters",
    "test_listings",
    "test_messages",
    "test_qos",
    "test_services",
    "test_time_and_transforms",
}
"""The files whose tests run beside each release; those of the others run beside Jazzy's."""

ANSWER_S = 60.0
"""The longest time for a verb of an end."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Record the row and the direction of each test of this folder, for the table."""
    for item in items:
        marker = item.get_closest_marker("row")
        if marker is None:
            continue
        (row,) = marker.args
        assert row in ROWS, row
        parameters = item.callspec.params if hasattr(item, "callspec") else {}
        direction = parameters.get("direction") or marker.kwargs["direction"]
        release = parameters.get("peer", JAZZY).name
        item.user_properties += [("row", row), ("direction", direction), ("release", release)]


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Run the tests of some files beside each release, if they don't say themselves beside which."""
    chosen = [mark for mark in metafunc.definition.iter_markers("parametrize") if "peer" in mark.args[0]]
    if "peer" in metafunc.fixturenames and not chosen:
        is_beside_all = metafunc.module.__name__.rpartition(".")[2] in ALSO_BESIDE_KILTED
        releases = (JAZZY, KILTED) if is_beside_all else (JAZZY,)
        metafunc.parametrize(
            "peer", releases, indirect=True, scope="session", ids=lambda release: release.name
        )


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Print a table for each release: of each row and direction, how many tests passed, failed and were skipped."""
    tables: dict[str, dict[tuple[str, str], Counter[str]]] = {}
    for outcome in ("passed", "failed", "error", "skipped"):
        for report in terminalreporter.stats.get(outcome, []):
            properties = dict(
                getattr(report, "user_properties", ())
            )  # a file that cannot be collected has none
            if "row" in properties:
                counts = tables.setdefault(properties["release"], {})
                cell = counts.setdefault((properties["row"], properties["direction"]), Counter())
                cell["failed" if outcome == "error" else outcome] += 1
    for release, counts in sorted(tables.items()):
        _print_table(terminalreporter, release, counts)


def _print_table(
    terminalreporter: pytest.TerminalReporter, release: str, counts: dict[tuple[str, str], Counter[str]]
) -> None:
    terminalreporter.section(f"tfloom beside the real rclpy of {release.capitalize()} on Fast DDS")
    cells = [[row, *(_cell(counts.get((row, direction))) for direction in DIRECTIONS)] for row in ROWS]
    table = [["", *DIRECTIONS], *cells]
    widths = [max(map(len, column)) for column in zip(*table, strict=True)]
    for line in table:
        padded = "  ".join(text.ljust(width) for text, width in zip(line, widths, strict=True))
        terminalreporter.write_line(padded.rstrip())


def _cell(counts: Counter[str] | None) -> str:
    if counts is None:
        return "not run"
    return ", ".join(
        f"{counts[outcome]} {outcome}" for outcome in ("passed", "failed", "skipped") if counts[outcome]
    )


class EndError(Exception):
    """A verb of an end raised; the text is its traceback."""


class End:
    """A process that runs programs/end.py; each call is a verb there."""

    def __init__(self, program: Program, vendor: str) -> None:
        self.program = program
        self.vendor = vendor
        self._answers = 0
        self.answer()

    def __call__(self, verb: str, *arguments: Any) -> Any:
        assert self.program.process.stdin is not None
        self.program.process.stdin.write(json.dumps([verb, *arguments]) + "\n")
        self.program.process.stdin.flush()
        return self.answer()

    def answer(self) -> Any:
        """Return the next answer."""
        end = time.monotonic() + ANSWER_S
        while True:
            answers = [line for line in list(self.program.lines) if line.startswith("= ")]
            if len(answers) > self._answers:
                break
            if self.program.process.poll() is not None or time.monotonic() > end:
                pytest.fail(f"the end of {self.vendor} does not answer; it printed:\n{self.program.output}")
            time.sleep(0.002)
        result = json.loads(answers[self._answers][2:])
        self._answers += 1
        if isinstance(result, dict) and "error" in result:
            raise EndError(result["error"])
        return result


class Ends(NamedTuple):
    """The two ends of a direction."""

    writer: End
    reader: End


StartEnd = Callable[..., End]


@pytest.fixture(scope="session")
def peer(request: pytest.FixtureRequest) -> RosPeer:
    """Return the real rclpy of a release; skip the test where there is none."""
    release: Release = request.param
    try:
        return find(release=release)
    except NoPeerError as error:
        pytest.skip(str(error))


def starter(peer: RosPeer, domain: int, start: Callable[..., Program], program_file: Path = END) -> StartEnd:
    """Return a function that starts an end of a vendor on a domain."""

    def start_end(vendor: str, name: str, *arguments: str, **variables: str) -> End:
        command: tuple[str | Path, ...] = (sys.executable, program_file)
        environment = {**os.environ, **variables}
        if vendor == THEIRS:
            command = (peer.python, program_file)
            environment = peer.environment(domain, ROS_LOG_DIR=os.environ["ROS_LOG_DIR"], **variables)
        program = start(*command, name, *arguments, stdin=subprocess.PIPE, env=environment)
        return End(program, vendor)

    return start_end


@pytest.fixture
def start_end(peer: RosPeer, domain_id: int, start_program: Callable[..., Program]) -> StartEnd:
    """Return a function that starts an end: `start_end(THEIRS, "talker", "--ros-args", …)`."""
    return starter(peer, domain_id, start_program)


@pytest.fixture(scope="module")
def start_module_end(
    peer: RosPeer, module_domain_id: int, start_module_program: Callable[..., Program]
) -> StartEnd:
    """Return a function as `start_end`, of ends that all tests of the module share."""
    return starter(peer, module_domain_id, start_module_program)


@pytest.fixture(params=DIRECTIONS)
def direction(request: pytest.FixtureRequest) -> str:
    """Return from which vendor to which messages pass."""
    return str(request.param)


def vendors(direction: str) -> tuple[str, str]:
    """Return the vendors of a direction: the writer's, and the reader's."""
    return (OURS, THEIRS) if direction == FROM_US else (THEIRS, OURS)


@pytest.fixture(scope="module")
def module_ends(start_module_end: StartEnd) -> dict[str, End]:
    """Return an end of each vendor."""
    return {vendor: start_module_end(vendor, vendor.lower().replace(" ", "_")) for vendor in (OURS, THEIRS)}


@pytest.fixture
def ends(module_ends: dict[str, End], direction: str) -> Ends:
    """Return the module's ends as the writer's and the reader's."""
    writer, reader = vendors(direction)
    return Ends(module_ends[writer], module_ends[reader])


@pytest.fixture
def new_ends(start_end: StartEnd, direction: str) -> Ends:
    """Return new ends, as the writer's and the reader's."""
    writer, reader = vendors(direction)
    return Ends(start_end(writer, "the_writer"), start_end(reader, "the_reader"))
