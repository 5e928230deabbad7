"""Listings beside a program that is stopped: what it has announced can't arrive, and they say so."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
import transcript
from tests.conftest import Program
from tests.zenoh_ports import NEEDS_ZENOH, use_port_of

from tfloom.cli.shared.graph import MISSING

SILENT = Path(__file__).parent / "a_silent_node.py"

pytestmark = pytest.mark.skipif(
    sys.platform != "linux", reason="on DDS, ports of processes are known on Linux"
)


@pytest.fixture(params=["rmw_cyclonedds_cpp", pytest.param("rmw_zenoh_cpp", marks=NEEDS_ZENOH)])
def stopped(
    request: pytest.FixtureRequest,
    domain_id: int,
    monkeypatch: pytest.MonkeyPatch,
    start_program: Callable[..., Program],
    wait_until: Callable[..., None],
) -> Iterator[int]:
    """Yield the process of /second, which is stopped; /first goes on."""
    monkeypatch.setenv("RMW_IMPLEMENTATION", request.param)
    with use_port_of(domain_id):
        programs = []
        for name in ("first", "second"):
            words = ("python", SILENT, "--ros-args", "-r", f"__node:={name}")
            programs.append(start_program(*words, stdin=subprocess.PIPE))
            programs[-1].wait_for("ready")
        wait_until(lambda: transcript.run_here("node", "list").text == "/first\n/second")
        process = programs[-1].process.pid
        os.kill(process, signal.SIGSTOP)
        yield process
        os.kill(process, signal.SIGCONT)


@pytest.mark.parametrize(
    ("words", "is_listed"),
    [
        (("node", "list"), "/first"),
        (("service", "list"), "/first/get_parameters"),
        (("topic", "list"), "/rosout"),
        (("lifecycle", "nodes"), "/first"),
    ],
    ids=lambda words: " ".join(words) if isinstance(words, tuple) else "",
)
def test_listing_says_that_it_may_not_be_whole(
    stopped: int, words: tuple[str, ...], is_listed: str, wait_until: Callable[..., None]
) -> None:
    told = transcript.run_here(*words).text
    assert MISSING in told.splitlines()
    assert "/second" not in told
    assert is_listed in told
    os.kill(stopped, signal.SIGCONT)

    def is_whole() -> bool:
        listed = transcript.run_here(*words).text
        return MISSING not in listed and (words[0] == "topic" or "/second" in listed)

    wait_until(is_whole)
