"""The files and functions that the walks of the design and ARCHITECTURE.md name exist."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from tests.docs.page import DOCS

ROOT = DOCS.parent
WALKS = sorted((DOCS / "design").glob("*.md"))
PLACE = re.compile(r"`((?:[\w.]+/)+\w+\.(?:py|cpp|hpp))(?:: (\w+))?`")
"""A path with folders, and perhaps a function in it."""


def missing_places(text: str) -> list[str]:
    """Return the places of a text that don't exist; a path may leave out `native/` or `src/tfloom/`."""
    missing = []
    for path, function in PLACE.findall(re.sub(r"\s+", " ", text)):
        files = [
            ROOT / start / path for start in ("", "src/tfloom", "native") if (ROOT / start / path).is_file()
        ]
        if not files or (function and not re.search(rf"\b{function}\b\(", files[0].read_text("utf-8"))):
            missing.append(f"{path}: {function}")
    return missing


@pytest.mark.parametrize("page", [*WALKS, ROOT / "ARCHITECTURE.md"], ids=lambda page: page.stem)
def test_named_places_exist(page: Path) -> None:
    text = page.read_text("utf-8")
    assert PLACE.search(re.sub(r"\s+", " ", text))
    assert missing_places(text) == []


def test_places_that_do_not_exist_are_found() -> None:
    text = "`native/tf2/buffer.cpp: lookup`, `native/tf2/buffer.cpp:\nlook_up`, `tf2_ros/none.py`, `tf2_ros/buffer.py`"
    assert missing_places(text) == ["native/tf2/buffer.cpp: look_up", "tf2_ros/none.py: "]
