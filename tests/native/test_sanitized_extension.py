"""The whole extension under sanitizers: tests of the wire, the buffer and the codec, in this Python with libddsc.

Neither Python nor libddsc is instrumented, so a finding is in the extension's own code.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tests.native.test_sanitizers import build_extension
from tests.shared_folders import shared_folder

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
RUN_TIMEOUT_S = 1200
EVERYWHERE = [
    "tests/rmw",
    # What Zenoh has in Python; its data reach the extension in test_zenoh_wire.py.
    "--ignore-glob=*/test_zenoh_[!w]*.py",
    "tests/tf2_ros/test_lifetime.py",
    "tests/tf2_ros/test_wire.py",
]
TESTS = {
    "address,undefined": [
        *EVERYWHERE,
        "tests/tf2",
        "tests/rosidl/test_cdr.py",
        "tests/rosidl/test_message.py",
    ],
    "thread": [*EVERYWHERE, "tests/tf2/test_threads.py", "tests/node/wire/test_services.py"],
}
"""The order differs from that of test_sanitizers.py, so that both files don't wait for the same build."""
RUNTIMES = {"thread": "libtsan.so", "address,undefined": "libasan.so"}
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform != "linux", reason="the sanitizer's runtime is preloaded as on Linux"),
]


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
            "ignore_noninstrumented_modules=1:report_signal_unsafe=0:exitcode=0:"
            f"suppressions='{HERE / 'sanitized' / 'threads.supp'}':log_path='{reports}'"  # paths may have a space
        ),
    }


@pytest.mark.parametrize("sanitize", TESTS)
def test_the_extension_under_sanitizers(
    sanitize: str, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    with shared_folder(tmp_path_factory, sanitize) as folder:
        extension = build_extension(folder, sanitize)
    variables = environment(extension, RUNTIMES[sanitize], tmp_path / "report")

    def run(*words: str) -> str:
        done = run_to_end([sys.executable, *words], cwd=ROOT, env=variables, timeout_s=RUN_TIMEOUT_S)
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
    run("-m", "pytest", *options, *TESTS[sanitize])
    findings = "\n".join(path.read_text("utf-8") for path in tmp_path.glob("report.*"))
    assert not findings
