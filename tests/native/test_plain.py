"""The benchmarks of the native optimisations match the code: every edit applies, and every row has its parts."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from benchmarks.native import plain
from benchmarks.native.plain import EDITS, NATIVE, write_plain


@pytest.mark.parametrize("name", EDITS)
def test_edits_apply_to_the_code(name: str, tmp_path: Path) -> None:
    for path in write_plain(name, tmp_path):
        assert (tmp_path / path).read_text("utf-8") != (NATIVE / path).read_text("utf-8")


def test_edit_that_does_not_apply_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(plain.EDITS, "planted", {"core/utf8.hpp": [("no such text", "")]})
    with pytest.raises(ValueError, match=r"'planted': native/core/utf8.hpp has this 0 times"):
        write_plain("planted", tmp_path)


@pytest.mark.parametrize("name", [*EDITS, "frozen file"])
def test_code_comments_name_their_benchmark_rows(name: str) -> None:
    texts = [path.read_text("utf-8") for path in NATIVE.rglob("*.?pp")]
    comments = [" ".join(re.findall(r"//\s*(.*)", text)) for text in texts]
    assert any("benchmarks/native" in text and f'"{name}"' in text for text in comments)
