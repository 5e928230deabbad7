"""A node without responses: the verbs report it, and list the responses of the other nodes."""

from __future__ import annotations

import os
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import pytest
import transcript
from tests.conftest import Program

from tfloom.cli import lifecycle
from tfloom.cli.param import parameter_services

HERE = Path(__file__).parent


def test_default_waits_have_their_values() -> None:
    assert (parameter_services.TIMEOUT_S, lifecycle.TIMEOUT_S) == (5.0, 10.0)


@pytest.fixture(scope="module")
def silent_node(module_domain_id: int, start_module_program: Callable[..., Program]) -> None:
    start_module_program("python", HERE / "a_silent_node.py", stdin=subprocess.PIPE).wait_for("ready")


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Shorten the waits for responses."""
    monkeypatch.setattr(parameter_services, "TIMEOUT_S", 2.0)
    monkeypatch.setattr(lifecycle, "TIMEOUT_S", 2.5)


@pytest.mark.usefixtures("silent_node", "quick")
def test_no_response_gives_an_error_message() -> None:
    answer = transcript.run_here("param", "list")
    assert (answer.text, answer.exit_code) == (
        "no response from /a_silent_node/list_parameters within 2 s",
        1,
    )


@pytest.mark.usefixtures("silent_node")
@pytest.mark.parametrize(
    ("words", "service"),
    [
        (("lifecycle", "get", "/a_silent_node"), "get_state"),
        (("component", "list"), "_container/list_nodes"),
        (("component", "load", "/a_silent_node", "a_package", "A"), "_container/load_node"),
        (("component", "unload", "/a_silent_node", "1"), "_container/unload_node"),
    ],
)
def test_wait_for_a_response_is_as_long_as_requested(words: tuple[str, ...], service: str) -> None:
    start_s = time.monotonic()
    answer = transcript.run_here(*words, "--timeout", "0.7")
    said = f"no response from /a_silent_node/{service} within 0.7 s"
    assert (answer.text, answer.exit_code) == (said, 1)
    assert time.monotonic() - start_s >= 0.7


@pytest.mark.usefixtures("silent_node")
@pytest.mark.parametrize("words", [("list", "/a_silent_node"), ("set", "/a_silent_node", "configure")])
def test_wait_for_a_server_is_as_long_as_requested(words: tuple[str, ...]) -> None:
    answer = transcript.run_here("lifecycle", *words, "--timeout", "0.6")
    said = "no server of /a_silent_node/get_available_transitions: waited 0.6 s for it"
    assert (answer.text, answer.exit_code) == (said, 1)


@pytest.mark.parametrize("words", [("lifecycle", "get"), ("component", "list")])
def test_timeouts_are_shown_from_lyrical_on_and_checked(words: tuple[str, ...]) -> None:
    older, newer = (
        transcript.run(*words, "-h", env={**os.environ, "ROS_DISTRO": distribution}).text
        for distribution in ("kilted", "lyrical")
    )
    assert "--timeout" not in older
    assert "[--timeout N]" in newer
    answer = transcript.run_here(*words, "--timeout", "-1")
    assert answer.exit_code == 2
    assert "argument --timeout: must be a number of seconds that isn't negative" in answer.text


@pytest.mark.usefixtures("silent_node")
@pytest.mark.skipif(os.name != "posix", reason="needs a pseudo-terminal")
def test_terminal_gets_a_message_about_the_wait(start_program: Callable[..., Program]) -> None:
    words = ("service", "call", "--timeout", "1.2", "/silence", "std_srvs/srv/Empty")
    piped = transcript.run_here(*words).text
    assert "to answer" not in piped
    command = [str(transcript.PROGRAM), *words]
    shown = start_program("python", "-c", f"import pty; pty.spawn({command})")
    shown.wait_for("waiting for a response from /silence")
    shown.wait_for("no response from /silence within 1.2 s")


@pytest.mark.usefixtures("silent_node", "quick")
def test_lists_contain_the_nodes_that_respond(start_program: Callable[..., Program]) -> None:
    start_program("python", HERE / "a_lifecycle_node.py").wait_for("ready")
    parameters = transcript.run_here("param", "list", "--filter", "use_sim_time")
    assert parameters.text.splitlines() == [
        "no response from /a_silent_node/list_parameters within 2 s",
        "/a_node:",
        "  use_sim_time",
    ]
    states = transcript.run_here("lifecycle", "get")
    assert states.text.splitlines() == [
        "no response from /a_silent_node/get_state within 2.5 s",
        "/a_node: unconfigured [1]",
    ]
    assert parameters.exit_code == states.exit_code == 0
