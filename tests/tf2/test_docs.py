"""The code in docs/tf2.md runs, its output is the documented one, and the example is quoted exactly."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "tf2.md").read_text("utf-8")
EXAMPLE = (ROOT / "examples" / "deskew_cloud.py").read_text("utf-8")


def blocks() -> Iterator[tuple[str, str]]:
    for found in re.finditer(r"^```(.*)\n((?:.*\n)*?)```$", PAGE, re.MULTILINE):
        yield found[1], found[2]


def test_documented_code_prints_the_documented_output(capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, object] = {}
    checked = 0
    for kind, text in blocks():
        if kind == "python":
            exec(text, names)
        elif kind == "text":
            assert capsys.readouterr().out == text
            checked += 1
    assert checked == 2


def test_page_quotes_the_example() -> None:
    quotes = [text for kind, text in blocks() if kind == "python example"]
    assert len(quotes) == 2
    assert all(quote in EXAMPLE for quote in quotes)


def test_links_have_targets() -> None:
    links = re.findall(r"\]\(([^)#]+)\)", PAGE)
    assert len(links) >= 3
    assert [link for link in links if not (ROOT / "docs" / link).exists()] == []
