"""The C++ programs of this folder and the whole extension, built with a sanitizer from the core's sources and run.

The extension runs tests of the wire, the buffer and the codec, in this Python with libddsc. Neither is instrumented, so
a finding is in the extension's own code.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tests.shared_folders import shared_folder

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
BUILD_TIMEOUT_S = 1800
PROGRAM_TIMEOUT_S = 600
TESTS_TIMEOUT_S = 1200
PROGRAMS = [
    "buffer_threads",
    "chunk_threads",
    "dds_ownership",
    "hostile_tf",
    "observer_threads",
    "paced_senders",
    "queue_threads",
    "service_clients",
]
TESTS_OF_THE_WIRE = [
    "tests/rmw",
    # What Zenoh has in Python; its data reach the extension in test_zenoh_wire.py.
    "--ignore-glob=*/test_zenoh_[!w]*.py",
    # What is Python alone, in this process or in those that it starts, which take seconds each under a sanitizer.
    *(
        f"--ignore=tests/rmw/test_{name}.py"
        for name in (
            "backends",
            "compatibility",
            "cyclone_config",
            "cyclone_ports",
            "loopback",
            "ports_and_pages",
        )
    ),
    "tests/tf2_ros/test_lifetime.py",
    "tests/tf2_ros/test_wire.py",
]
CMAKE_OPTIONS = [
    "-DTFLOOM_NATIVE_TESTS=ON",
    "-DCMAKE_BUILD_TYPE=None",
]


def cmake() -> str:
    """Return the path of cmake."""
    found = shutil.which("cmake", path=f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")
    assert found, "cmake is not installed: install the dependency group 'build'"
    return found


def configure(folder: Path, *options: str) -> None:
    """Have CMake write the build of the core and the extension, with more options."""
    find_nanobind = [sys.executable, "-m", "nanobind", "--cmake_dir"]
    nanobind = subprocess.run(find_nanobind, capture_output=True, text=True, check=True).stdout.strip()
    run_cmake(
        *("-S", str(ROOT), "-B", str(folder), *options),
        "-DTFLOOM_WARNINGS_AS_ERRORS=ON",
        "-DSKBUILD=2",
        f"-DPython_EXECUTABLE={sys.executable}",
        f"-Dnanobind_DIR={nanobind}",
    )


def run_cmake(*arguments: str) -> None:
    done = run_to_end([cmake(), *arguments], timeout_s=BUILD_TIMEOUT_S)
    assert done.returncode == 0, done.stdout + done.stderr


def build(folder: Path, sanitize: str, targets: list[str]) -> None:
    """Build targets with a sanitizer in a folder, where an earlier build is continued.

    The programs and the extension share the core's library, which is compiled once for each sanitizer.
    """
    # Half of compiling would be optimising what checks addresses; what checks threads compiles no faster without it.
    level = "-O1" if sanitize == "thread" else "-O0"
    # The optimiser of GCC 12 warns of code that only instrumentation makes.
    flags = f"{level} -Wno-error=maybe-uninitialized -Wno-error=restrict -Wno-error=tsan"
    configure(folder, *CMAKE_OPTIONS, f"-DTFLOOM_SANITIZE={sanitize}", f"-DCMAKE_CXX_FLAGS={flags}")
    run_cmake("--build", str(folder), "--parallel", str(os.cpu_count() or 1), "--target", *targets)


def build_programs(folder: Path, sanitize: str, programs: list[str]) -> list[Path]:
    """Build programs of this folder, and return their paths."""
    build(folder, sanitize, programs)
    return [folder / "tests" / "native" / program for program in programs]


def build_extension(folder: Path, sanitize: str) -> Path:
    """Build the extension, and return its path."""
    build(folder, sanitize, ["_native"])
    (extension,) = folder.glob("_native*.so")
    return extension


def run_programs(sanitize: str, factory: pytest.TempPathFactory) -> None:
    """Build the programs with a sanitizer and run them; fail with the output of the first that fails."""
    with shared_folder(factory, sanitize) as folder:
        programs = build_programs(folder, sanitize, PROGRAMS)
    environment = {
        **os.environ,
        "TSAN_OPTIONS": "halt_on_error=1",
        "UBSAN_OPTIONS": "halt_on_error=1:print_stacktrace=1",
        "ASAN_OPTIONS": "detect_leaks=0",
    }
    for program in programs:
        done = run_to_end([program], env=environment, timeout_s=PROGRAM_TIMEOUT_S)
        assert done.returncode == 0, f"{program.name} under {sanitize}:\n{done.stdout}{done.stderr}"


def environment(extension: Path, runtime: str, reports: Path) -> dict[str, str]:
    """Return the environment of a Python that loads this extension, and writes its findings to `reports`."""
    # The runtime of C++ too, because the sanitizer intercepts its throw where it is loaded.
    libraries = [
        subprocess.run(["gcc", f"-print-file-name={name}"], capture_output=True, text=True, check=True).stdout
        for name in (runtime, "libstdc++.so")
    ]
    return {
        **os.environ,
        "LD_PRELOAD": " ".join(path.strip() for path in libraries),
        "PYTHONPATH": str(HERE / "sanitized"),
        "TFLOOM_SANITIZED_NATIVE": str(extension),
        "ASAN_OPTIONS": f"detect_leaks=0:log_path='{reports}'",  # Python never frees all its memory
        "UBSAN_OPTIONS": f"halt_on_error=1:print_stacktrace=1:log_path='{reports}'",
        "TSAN_OPTIONS": (
            # At exit, its runtime would wait a second for what other threads do. Python has ended by then, and a thread
            # that still waits for the GIL gets it there: a moment in which the process has gone otherwise.
            "atexit_sleep_ms=0:"
            "ignore_noninstrumented_modules=1:report_signal_unsafe=0:exitcode=0:"
            f"suppressions='{HERE / 'sanitized' / 'threads.supp'}':log_path='{reports}'"  # paths may have a space
        ),
    }


def run_extension(
    sanitize: str, runtime: str, tests: list[str], reports: Path, factory: pytest.TempPathFactory
) -> None:
    """Build the extension with a sanitizer and run tests with it; fail with what is found.

    Args:
        runtime: The file of the sanitizer's library, which is preloaded, because Python is not linked with it.
    """
    with shared_folder(factory, sanitize) as folder:
        extension = build_extension(folder, sanitize)
    variables = environment(extension, runtime, reports / "report")

    def run(*words: str) -> str:
        done = run_to_end([sys.executable, *words], cwd=ROOT, env=variables, timeout_s=TESTS_TIMEOUT_S)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    assert run("-c", "import tfloom._native as n; print(n.__spec__.origin)").strip() == str(extension)
    options = [
        "-q",
        "-p",
        "no:cacheprovider",
        "-m",
        "not slow and not timing and not ros",
        "--numprocesses=2",
        "--dist=loadfile",
    ]
    run("-m", "pytest", *options, *tests)
    findings = "\n".join(path.read_text("utf-8") for path in reports.glob("report.*"))
    assert not findings, findings
