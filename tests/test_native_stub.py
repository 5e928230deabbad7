"""`_native.pyi` is what nanobind's stubgen makes of the extension that is installed."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
STUB = ROOT / "src" / "tfloom" / "_native.pyi"
PATTERNS = ROOT / "native" / "bindings" / "stub_patterns.txt"
STUBGEN = ("-m", "nanobind.stubgen", "-m", "tfloom._native", "-q", "-p", str(PATTERNS), "-o")


def test_stub_is_current(tmp_path: Path) -> None:
    fresh = tmp_path / "_native.pyi"
    subprocess.run([sys.executable, *STUBGEN, str(fresh)], check=True, timeout=120)
    command = "make stub"
    assert STUB.read_text("utf-8") == fresh.read_text("utf-8"), f"the extension's face has changed: {command}"


def test_every_argument_has_a_name_and_every_function_a_docstring() -> None:
    text = STUB.read_text("utf-8")
    assert not re.search(r"\barg\d*\s*[:,)]", text)
    text = re.sub(r"@\w+\.setter\n.*\n", "", text)  # documented by its property
    text = re.sub(r"@overload\ndef .*: \.\.\.\n", "", text)  # by the first of its overloads
    undocumented = re.findall(r"^\s*def ([a-z]\w*)\(.*: \.\.\.$", text, re.MULTILINE)
    assert not undocumented
