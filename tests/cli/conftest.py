"""Fixtures of the tests of the commands."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.conftest import Program

from tfloom.node.context.context import Context
from tfloom.node.node import Node
from tfloom.workspace import index

sys.path.append(str(Path(__file__).parent))
pytest.register_assert_rewrite("transcript")

TURTLESIM = ("tfloom", "run", "turtlesim", "turtlesim_node")
SPAWNED = "Spawning turtle [turtle1]"


@pytest.fixture(scope="module")
def turtlesim(module_domain_id: int, start_module_program: Callable[..., Program]) -> None:
    """Start turtlesim for the tests of a module that don't change it."""
    start_module_program(*TURTLESIM).wait_for(SPAWNED)


@pytest.fixture
def turtlesim_to_change(domain_id: int, start_program: Callable[..., Program]) -> Program:
    """Start another turtlesim, on a separate domain."""
    program = start_program(*TURTLESIM)
    program.wait_for(SPAWNED)
    return program


@pytest.fixture
def onlooker(domain_id: int) -> Iterator[Node]:
    """Return a node that sees the graph of the test."""
    context = Context()
    context.init(args=[], domain_id=domain_id)
    yield Node("onlooker", context=context)
    context.destroy()


@pytest.fixture
def prefix(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the prefix of a sourced workspace, which has the package `my_pkg`, without a file."""
    monkeypatch.setenv(index.PREFIX_PATH_VARIABLE, str(tmp_path))
    marker = tmp_path / index.RESOURCE_INDEX / "packages" / "my_pkg"
    marker.parent.mkdir(parents=True)
    marker.touch()
    return tmp_path


@pytest.fixture
def run_tf() -> Callable[..., tuple[int, str]]:
    """Run `tf …` to its end in this process; return exit code and output."""
    from transcript import run_here

    def run(*words: str | Path) -> tuple[int, str]:
        answer = run_here("tf", *map(str, words))
        return answer.exit_code, answer.text

    return run
