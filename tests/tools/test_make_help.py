"""`make help` prints one line for each target, and names only commands that exist."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from tests.conftest import run_to_end

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def lines() -> list[str]:
    if shutil.which("make") is None:
        pytest.skip("needs make")
    done = run_to_end(["make", "help"], cwd=ROOT)
    assert (done.returncode, done.stderr) == (0, "")
    return list(done.stdout.splitlines())


def test_each_target_has_a_line(lines: list[str]) -> None:
    phony = re.search(r"^\.PHONY: (.*)$", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE)
    assert phony
    assert sorted(line.split()[1] for line in lines if line.startswith("make ")) == sorted(phony[1].split())


def test_each_command_exists(lines: list[str]) -> None:
    modules = [name for line in lines for name in re.findall(r"-m ([\w.]+)", line)]
    files = [line.split()[0] for line in lines if re.match(r"(\.ci|docs|tools)/", line)]
    assert len(modules) > 8
    assert len(files) >= 5
    for name in modules:
        path = ROOT / ("src" if name.startswith("tfloom") else "") / name.replace(".", "/")
        assert path.is_dir() or path.with_suffix(".py").is_file(), name
    for name in files:
        assert (ROOT / name).is_file(), name
