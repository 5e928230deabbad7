"""Runs of pytest on test files of users, each a separate process."""

from __future__ import annotations

import os
import sys
import xml.etree.ElementTree as ET
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import pytest
from tests.conftest import PYTEST, run_to_end


class Case(NamedTuple):
    """The result of one item."""

    outcome: str
    text: str


class Run(NamedTuple):
    """A run of pytest."""

    code: int
    output: str
    cases: dict[str, Case]
    """By the name of the file and that of the item: `test_good::test_good`."""

    def outcome(self, name: str) -> str:
        return self.cases[name].outcome


def run_pytest(folder: Path, files: Mapping[str, str], *words: str, **environment: str) -> Run:
    """Run pytest on files with these texts, in their own folder; a hanging test is ended after a time."""
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, "utf-8")
    (folder / "pytest.ini").write_text("[pytest]\nfaulthandler_timeout = 100\n")
    results = folder / "results.xml"
    clean = {name: value for name, value in os.environ.items() if not name.startswith(("PYTEST_", "CI"))}
    command = [sys.executable, *PYTEST, "-p", "no:cacheprovider", f"--junit-xml={results}", *words]
    result = run_to_end(
        command, cwd=folder, env={**clean, "ROS_LOG_DIR": str(folder / "log"), **environment}, timeout_s=240
    )
    return Run(
        result.returncode, result.stdout + result.stderr, dict(_cases(results)) if results.is_file() else {}
    )


def _cases(results: Path) -> list[tuple[str, Case]]:
    cases = []
    for element in ET.parse(results).getroot().iter("testcase"):
        bad = next((child for child in element if child.tag in {"failure", "error", "skipped"}), None)
        text = "" if bad is None else f"{bad.get('message')}\n{bad.text}"
        name = "::".join(filter(None, (element.get("classname"), element.get("name"))))
        cases.append((name, Case("passed" if bad is None else bad.tag, text)))
    return cases


@pytest.fixture(scope="session", name="run_pytest")
def _run_pytest():
    return run_pytest
