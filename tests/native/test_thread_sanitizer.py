"""The programs and the extension under the sanitizer of threads."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from tests.native.sanitizers import TESTS_OF_THE_WIRE, run_extension, run_programs

SANITIZE = "thread"
TESTS = [*TESTS_OF_THE_WIRE, "tests/tf2/test_threads.py", "tests/node/wire/test_services.py"]
pytestmark = pytest.mark.slow


@pytest.mark.skipif(sys.platform == "win32", reason="MSVC has no ThreadSanitizer")
def test_core_passes(tmp_path_factory: pytest.TempPathFactory) -> None:
    run_programs(SANITIZE, tmp_path_factory)


@pytest.mark.skipif(sys.platform != "linux", reason="the sanitizer's runtime is preloaded as on Linux")
def test_the_extension_passes(tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    run_extension(SANITIZE, "libtsan.so", TESTS, tmp_path, tmp_path_factory)
