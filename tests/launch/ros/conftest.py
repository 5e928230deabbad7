"""A package with a program that prints its arguments, and the files among them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

SHOW = """#!/bin/sh
for word; do
    echo "word $word"
    if [ -f "$word" ]; then sed 's/^/file /' "$word"; fi
done
"""


def make_package(prefix: Path, name: str, **programs: str) -> Path:
    """Install a package with scripts, and return its share folder."""
    marker = prefix / "share" / "ament_index" / "resource_index" / "packages" / name
    share = prefix / "share" / name
    library = prefix / "lib" / name
    for folder in (marker.parent, share, library):
        folder.mkdir(parents=True, exist_ok=True)
    marker.touch()
    for program, text in programs.items():
        (library / program).write_text(text, "utf-8")
        (library / program).chmod(0o755)
    return share


@pytest.fixture
def toys(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the prefix of a package `toys`, whose program is `show`."""
    prefix = tmp_path / "install"
    make_package(prefix, "toys", show=SHOW)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(prefix))
    return prefix


@pytest.fixture
def words(launch: Callable[..., object], toys: Path) -> Callable[..., list[str]]:
    """Return a function that launches entities, and returns what the programs `show` have printed, all in order."""

    def words(*entities: object) -> list[str]:
        ran = launch(*entities)
        assert ran.code == 0, ran.lines
        shown = [line.partition("] ") for line in ran.lines if line.startswith("[show-")]
        shown.sort(key=lambda parts: int(parts[0].partition("-")[2]))
        return [line for _, _, line in shown]

    return words
