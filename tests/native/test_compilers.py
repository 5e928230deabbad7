"""native/ compiles with a second compiler and library, clang with libc++, and for the systems that aren't this one.

For the others, clang comes with their headers in the package ziglang, and compiles its own libraries first, which takes
minutes: TFLOOM_CROSS_COMPILE=1 asks for it. The bindings are left out there, because they need the headers of that
system's Python.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tests.native.sanitizers import configure
from tests.shared_folders import shared_folder

ROOT = Path(__file__).parents[2]
NATIVE = ROOT / "native"
WARNINGS = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Werror"]
OF_SYSTEMS = re.compile(r"_WIN32|__APPLE__|__linux__|_MSC_VER|__aarch64__|__x86_64__|__GNUC__")
TARGETS = [
    "x86_64-windows-gnu",
    "aarch64-macos.11.0",
    "x86_64-macos.11.0",
    "aarch64-linux-gnu",
    "x86_64-linux-musl",
]

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(os.name != "posix", reason="the places of commands are POSIX's"),
]


def clang() -> str | None:
    """Return a clang of version 15 or newer that has libc++; None if there is none."""
    for name in ("clang++", *(f"clang++-{version}" for version in range(21, 14, -1))):
        if shutil.which(name) is None:
            continue
        program = "#include <concepts>\n#include <span>\n"
        command = [name, "-stdlib=libc++", "-std=c++20", "-fsyntax-only", "-x", "c++", "-"]
        if not run_to_end(command, input=program).returncode:
            return name
    return None


def failures(commands: dict[str, list[str]]) -> list[str]:
    """Run the compiler's command for each source, in parallel; return what it prints of those that fail.

    No code is generated, which takes half the time: clang's front end gives all of these warnings.
    """

    def messages(source: str) -> str:
        done = run_to_end([*commands[source], "-fsyntax-only"], timeout_s=600)
        return f"{source}:\n{done.stderr}" if done.returncode else ""

    with ThreadPoolExecutor(os.cpu_count()) as threads:
        return list(filter(None, threads.map(messages, commands)))


def test_clang_with_libcxx_compiles_all_without_a_warning(tmp_path: Path) -> None:
    """Several files at a time, as the build has them, because clang takes most of its time for their headers."""
    compiler = clang()
    if compiler is None:
        pytest.skip(
            "no clang with libc++ is installed: apt-get install clang-16 libc++-16-dev libc++abi-16-dev"
        )
    configure(
        tmp_path,
        f"-DCMAKE_CXX_COMPILER={compiler}",
        "-DCMAKE_CXX_COMPILER_LAUNCHER=",
        "-DCMAKE_CXX_FLAGS=-stdlib=libc++",
        "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
    )
    entries = json.loads((tmp_path / "compile_commands.json").read_text("utf-8"))
    commands = {
        entry["file"]: shlex.split(entry["command"])
        for entry in entries
        if not entry["output"].startswith("CMakeFiles/nanobind")
    }
    failed = failures(commands)
    assert not failed, "\n".join(failed)


@pytest.fixture(scope="module")
def zig(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """Install the package ziglang, and return the command of its clang."""
    if "TFLOOM_CROSS_COMPILE" not in os.environ:
        pytest.skip("compiling for other systems takes minutes: TFLOOM_CROSS_COMPILE=1 asks for it")
    with shared_folder(tmp_path_factory, "ziglang") as folder:
        python = folder / "venv" / "bin" / "python"
        if not python.exists():
            subprocess.run([sys.executable, "-m", "venv", python.parents[1]], check=True, timeout=120)
        subprocess.run([python, "-m", "pip", "install", "--quiet", "ziglang>=0.13"], check=True, timeout=600)
        return ["env", f"ZIG_GLOBAL_CACHE_DIR={folder / 'cache'}", str(python), "-m", "ziglang", "c++"]


def check_for(target: str, zig: list[str], sources: list[Path]) -> list[str]:
    """Have sources checked for another system; return what zig's clang prints of those that fail."""
    command = [*zig, "-target", target, *WARNINGS, f"-I{NATIVE}"]
    return failures({str(source): [*command, str(source)] for source in sources})


@pytest.mark.parametrize("target", TARGETS)
def test_what_differs_between_systems_compiles_for_each(zig: list[str], target: str) -> None:
    sources = [path for path in sorted(NATIVE.rglob("*.cpp")) if path.parent.name != "bindings"]
    of_systems = [
        path
        for path in sources
        if any(
            OF_SYSTEMS.search(part.read_text("utf-8"))
            for part in (path, path.with_suffix(".hpp"))
            if part.exists()
        )
    ]
    assert len(of_systems) > 5
    failed = check_for(target, zig, of_systems)
    assert not failed, "\n".join(failed)


def test_a_fault_of_another_system_is_found(zig: list[str], tmp_path: Path) -> None:
    source = tmp_path / "fault.cpp"
    source.write_text("#ifdef _WIN32\nint f() { return nothing; }\n#endif\nint g();\nint g() { return 1; }\n")
    assert not check_for("x86_64-linux-musl", zig, [source])
    assert "nothing" in "".join(check_for("x86_64-windows-gnu", zig, [source]))
