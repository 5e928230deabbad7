"""`doctor`: what it finds amiss, and its exit code."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
import transcript


def findings(*flags: str, **environment: str) -> tuple[dict[str, dict[str, object]], int]:
    answer = transcript.run("doctor", "--json", *flags, env={**os.environ, **environment})
    return {finding["check"]: finding for finding in json.loads(answer.text)}, answer.exit_code


@pytest.mark.wire
def test_all_is_well(domain_id: int) -> None:
    answer = transcript.run("doctor")
    assert answer.exit_code == 0, answer.text
    assert "domain: domain %d, discovery range LOCALHOST" % domain_id in answer.text  # noqa: UP031
    assert "a message came through" in answer.text
    assert answer.text.endswith("\nAll 7 checks passed")


@pytest.mark.parametrize(
    ("environment", "check"),
    [
        ({"RMW_IMPLEMENTATION": "rmw_none"}, "wire"),
        ({"ROS_DOMAIN_ID": "300"}, "domain"),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "NEAR"}, "domain"),
    ],
)
def test_a_setting_that_cannot_be_is_a_failure(environment: dict[str, str], check: str) -> None:
    found, exit_code = findings(**environment)
    assert exit_code == 1
    assert found[check]["verdict"] == "failed"
    assert found[check]["summary"]


def test_a_mixture_with_a_real_ros_is_a_failure(tmp_path: Path) -> None:
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").write_text("")
    found, exit_code = findings(PYTHONPATH=str(tmp_path), RMW_IMPLEMENTATION="tfloom_local")
    assert exit_code == 1
    assert found["names"]["verdict"] == "failed"
    assert f"rclpy from {tmp_path}" in str(found["names"]["summary"])
    assert findings("-ep", PYTHONPATH=str(tmp_path), RMW_IMPLEMENTATION="tfloom_local")[1] == 0


def test_a_real_command_on_the_path_is_a_warning(tmp_path: Path) -> None:
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


def test_reports() -> None:
    environment = {**os.environ, "RMW_IMPLEMENTATION": "tfloom_local", "ROS_DOMAIN_ID": "x"}
    whole = transcript.run("doctor", "--report", env=environment)
    failed = transcript.run("doctor", "--report-failed", env=environment)
    assert "reportlab: " in whole.text
    assert "reportlab: " not in failed.text
    assert "ROS_DOMAIN_ID: x" in failed.text
    assert failed.text.endswith("2/7 checks failed\nFailed: domain, round trip")
    assert whole.exit_code == failed.exit_code == 1


@pytest.mark.parametrize(
    ("words", "exit_code", "said"),
    [
        (("daemon", "status"), 0, "There is no daemon"),
        (("daemon", "start", "--debug"), 0, "There is no daemon"),
        (("component", "list", "--containers-only"), 1, "Components are C++"),
    ],
)
def test_what_is_not_needed_says_so(words: tuple[str, ...], exit_code: int, said: str) -> None:
    answer = transcript.run(*words)
    assert answer.exit_code == exit_code
    assert answer.text.startswith(said)
    assert len(answer.text.splitlines()) == 1
