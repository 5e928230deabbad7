"""The tests of the wire, run with libddsc 0.10, the version of distributions and of ROS 2 Jazzy, by TFLOOM_LIBDDSC.

The library is that of Debian 12: the installed one, or else its packages, downloaded and unpacked, not installed.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tests.conftest import run_to_end
from tools.platforms import TESTS_ON_DDS_0_10

ROOT = Path(__file__).parents[2]
VERSION = "0.10.2"
PACKAGES = (
    "libddsc0debian",
    "libiceoryx-binding-c2",
    "libiceoryx-hoofs2",
    "libiceoryx-platform2",
    "libiceoryx-posh2",
)
TIMEOUT_S = 600.0

pytestmark = [pytest.mark.slow, pytest.mark.wire]


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the path of Debian 12's libddsc."""
    multiarch = getattr(sys.implementation, "_multiarch", "")
    installed = Path(f"/usr/lib/{multiarch}/libddsc.so.{VERSION}")
    if installed.exists():
        return installed
    if shutil.which("apt-get") is None:
        pytest.skip("downloads packages by apt-get")
    folder = tmp_path_factory.mktemp("debian")
    done = run_to_end(["apt-get", "download", *PACKAGES], cwd=folder, timeout_s=TIMEOUT_S)
    for package in folder.glob("*.deb"):
        subprocess.run(["dpkg", "--extract", package, folder], check=True)
    unpacked = folder / installed.relative_to("/")
    if not unpacked.exists():
        pytest.skip(f"apt-get has no libddsc {VERSION} for this system: {done.stderr.strip()}")
    return unpacked


def test_the_tests_of_the_wire_pass_with_it(library: Path) -> None:
    """It is found in the environment, and its own dependencies beside it."""
    environment = os.environ | {"TFLOOM_LIBDDSC": str(library), "LD_LIBRARY_PATH": str(library.parent)}
    described = run_to_end([sys.executable, "-m", "tfloom", "doctor"], env=environment)
    assert f"libddsc {VERSION} of TFLOOM_LIBDDSC" in described.stdout, described.stdout + described.stderr
    done = run_to_end(
        [
            sys.executable,
            "-m",
            "pytest",
            "-q",
            "-n2",
            "-p",
            "no:cacheprovider",
            "-m",
            "not slow and not ros",
            *TESTS_ON_DDS_0_10,
        ],
        cwd=ROOT,
        env=environment,
        timeout_s=TIMEOUT_S,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    passed = re.search(r"(\d+) passed", done.stdout)
    assert passed is not None
    print(f"with libddsc {VERSION}: {passed[0]}")
