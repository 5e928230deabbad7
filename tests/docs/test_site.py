"""The site of `make docs`: it builds without a warning, and its API pages have every public module."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from tests.docs.page import DOCS

ROOT = DOCS.parent
ROOMS = {"tf2": "tf2", "tf2_ros": "tf2_ros"}
"""The rooms of which every module is on an API page, but for the internal ones."""
CHOSEN = {"bag", "robot"}
"""API pages with those modules of a room that programs import; the others make its commands and programs."""
INTERNAL = {
    "tf2.frozen": "its methods are Buffer's",
    "tf2.html": "used by notebooks",
    "tf2_ros.annotation_types": "names for annotations",
    "tf2_ros.deadlines": "used by buffer",
    "tf2_ros.far_stamps": "used by transform_listener",
    "tf2_ros.numpy_compat": "used by point_cloud2",
}
"""Modules without an entry, and why."""


def documented(page: str) -> set[str]:
    text = (DOCS / "api" / f"{page}.md").read_text("utf-8")
    found = re.findall(r"^\.\. auto(module|class|function|data):: tfloom\.(\S+)", text, re.MULTILINE)
    return {name if kind == "module" else name.rpartition(".")[0] for kind, name in found}


def test_every_public_module_has_an_entry() -> None:
    modules = {
        f"{room}.{'.'.join(path.relative_to(folder).with_suffix('').parts)}"
        for room in ROOMS
        for folder in [ROOT / "src" / "tfloom" / room]
        for path in folder.rglob("*.py")
        if path.name != "__init__.py" and not path.name.startswith("_")
    }
    entries = {name for page in ROOMS.values() for name in documented(page)}
    assert modules - entries == set(INTERNAL)
    assert entries <= modules
    for page in CHOSEN:
        assert len(documented(page)) >= 3
        for name in documented(page):
            assert (ROOT / "src" / "tfloom" / f"{name.replace('.', '/')}.py").is_file(), name


@pytest.mark.slow
def test_site_builds_without_a_warning(tmp_path: Path) -> None:
    pytest.importorskip("sphinx", reason="sphinx is not installed: make setup")
    done = subprocess.run(
        [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html", DOCS, tmp_path],
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
        cwd=ROOT,
    )
    assert (done.returncode, done.stderr) == (0, "")
    page = (tmp_path / "api" / "tf2.html").read_text("utf-8")
    assert 'id="tfloom.tf2.buffer.Buffer.lookup"' in page
    assert "https://" not in "".join(re.findall(r'<(?:script|link)[^>]*(?:src|href)="([^"]*)"', page))
