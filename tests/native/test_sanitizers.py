"""The C++ programs of this folder, built with sanitizers from the core's sources and run."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tests.shared_folders import shared_folder

ROOT = Path(__file__).parents[2]
BUILD_TIMEOUT_S = 1800
RUN_TIMEOUT_S = 600
pytestmark = pytest.mark.slow
PROGRAMS = [
    "buffer_threads",
    "chunk_threads",
    "dds_ownership",
    "hostile_tf",
    "observer_threads",
    "queue_threads",
    "service_clients",
]
CMAKE_OPTIONS = [
    "-DTFLOOM_WARNINGS_AS_ERRORS=ON",
    # The optimiser of GCC 12 warns of code that only instrumentation makes.
    "-DCMAKE_CXX_FLAGS=-O1 -Wno-error=maybe-uninitialized -Wno-error=restrict -Wno-error=tsan",
    "-DCMAKE_BUILD_TYPE=None",
]


def cmake() -> str:
    """Return the path of cmake."""
    found = shutil.which("cmake", path=f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")
    assert found, "cmake is not installed: install the dependency group 'build'"
    return found


def build(folder: Path, sanitize: str, targets: list[str]) -> None:
    """Build targets with a sanitizer in a folder, where an earlier build is continued.

    The programs and the extension share the core's library, which is compiled once for each sanitizer.
    """
    find_nanobind = [sys.executable, "-m", "nanobind", "--cmake_dir"]
    nanobind = subprocess.run(find_nanobind, capture_output=True, text=True, check=True).stdout.strip()
    options = [
        *CMAKE_OPTIONS,
        f"-DTFLOOM_SANITIZE={sanitize}",
        "-DTFLOOM_NATIVE_TESTS=ON",
        "-DSKBUILD=2",
        f"-DPython_EXECUTABLE={sys.executable}",
        f"-Dnanobind_DIR={nanobind}",
    ]
    parallel = str(os.cpu_count() or 1)
    for command in (
        [cmake(), "-S", ROOT, "-B", folder, *options],
        [cmake(), "--build", folder, "--parallel", parallel, "--target", *targets],
    ):
        done = run_to_end(command, timeout_s=BUILD_TIMEOUT_S)
        assert done.returncode == 0, done.stdout + done.stderr


def build_programs(folder: Path, sanitize: str, programs: list[str]) -> list[Path]:
    """Build programs of this folder, and return their paths."""
    build(folder, sanitize, programs)
    return [folder / "tests" / "native" / program for program in programs]


def build_extension(folder: Path, sanitize: str) -> Path:
    """Build the extension, and return its path."""
    build(folder, sanitize, ["_native"])
    (extension,) = folder.glob("_native*.so")
    return extension


@pytest.mark.skipif(sys.platform == "win32", reason="MSVC has no ThreadSanitizer")
@pytest.mark.parametrize("sanitize", ["thread", "address,undefined"])
def test_core_passes_under_sanitizers(sanitize: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    with shared_folder(tmp_path_factory, sanitize) as folder:
        programs = build_programs(folder, sanitize, PROGRAMS)
    environment = {
        **os.environ,
        "TSAN_OPTIONS": "halt_on_error=1",
        "UBSAN_OPTIONS": "halt_on_error=1:print_stacktrace=1",
        "ASAN_OPTIONS": "detect_leaks=0",
    }
    for program in programs:
        done = run_to_end([program], env=environment, timeout_s=RUN_TIMEOUT_S)
        assert done.returncode == 0, f"{program.name} under {sanitize}:\n{done.stdout}{done.stderr}"
