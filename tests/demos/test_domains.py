"""The domain of a demonstration: that of ROS_DOMAIN_ID, or one on which nobody is."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.spun import SpunNode, spun

from tfloom.cli import demo
from tfloom.cli.demo import nodes_on
from tfloom.demos import processes
from tfloom.demos.processes import own_domain
from tfloom.demos.program_group import ShowError

pytestmark = pytest.mark.wire


def test_domain_with_others_is_left_for_another() -> None:
    seen: list[int] = []

    def is_free(domain_id: int) -> bool:
        seen.append(domain_id)
        return len(seen) == 3

    with own_domain(is_free) as domain_id:
        assert domain_id == seen[-1]
        assert len({*seen}) == 3
    with pytest.raises(ShowError, match="others are on each of 5 DDS domains"), own_domain(lambda _: False):
        pass


def test_domain_of_another_demonstration_is_not_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    with own_domain(lambda _: True) as first:
        monkeypatch.setattr(processes, "DOMAINS", range(first, first + 1))
        with pytest.raises(ShowError, match="in use"), own_domain(lambda _: True):
            pass
    with own_domain(lambda _: True) as second:  # it is free again
        assert second == first


def test_nodes_of_a_domain_are_found_and_the_environment_stays(domain_id: int) -> None:
    os.environ["CYCLONEDDS_URI"] = "<CycloneDDS/>"
    try:
        before = dict(os.environ)
        assert nodes_on(domain_id) == []
        with spun(SpunNode("their_robot", domain_id)), spun(SpunNode("_hidden", domain_id)):
            assert nodes_on(domain_id) == ["/their_robot"]
        assert dict(os.environ) == before
    finally:
        del os.environ["CYCLONEDDS_URI"]


@pytest.mark.parametrize("which", ["turtles", "robot"])
def test_others_on_the_domain_that_was_asked_for_are_named(
    domain_id: int, start_program: Callable[..., Any], tmp_path: Path, which: str
) -> None:
    with spun(SpunNode("their_robot", domain_id)):
        demo = start_program("tfloom", "demo", which, "--seconds", "1", cwd=tmp_path)
        assert demo.wait() == 1
    said = f"on domain {domain_id} are already: /their_robot. The demonstration would drive them, too"
    assert said in demo.output, demo.output
    assert "Traceback" not in demo.output
    assert list(tmp_path.iterdir()) == []


def test_domain_0_is_not_said_to_be_asked_for(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for value in (None, "", "0"):
        monkeypatch.delenv("ROS_DOMAIN_ID", raising=False)
        if value is not None:
            monkeypatch.setenv("ROS_DOMAIN_ID", value)
        with demo._domain(is_shared=True) as domain_id:
            assert domain_id == 0
        said = "as ROS_DOMAIN_ID says" if value else "because ROS_DOMAIN_ID isn't set"
        assert capsys.readouterr().out == f"It runs on domain 0, {said}.\n"


@pytest.mark.parametrize("is_shared", [False, True])
def test_it_runs_on_the_domain_that_was_asked_for(
    domain_id: int, start_program: Callable[..., Any], tmp_path: Path, *, is_shared: bool
) -> None:
    with spun(SpunNode("observer" if is_shared else "_observer", domain_id)) as observer:
        words = ["--here"] if is_shared else []
        demo = start_program("tfloom", "demo", "--seconds", "60", *words, cwd=tmp_path)
        demo.wait_for(f"It runs on domain {domain_id}, as ROS_DOMAIN_ID says.")
        observer.spin_until(lambda: observer.node.count_publishers("/turtle1/cmd_vel"), "the turtle's driver")
    demo.signal(signal.SIGINT)
    assert demo.wait() == 0, demo.output
