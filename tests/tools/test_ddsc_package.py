"""packages/tfloom-ddsc: libddsc in its own wheel, taken from the wheel of cyclonedds for another Python."""

from __future__ import annotations

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from types import ModuleType

import pytest
from packaging.requirements import Requirement
from tests.conftest import run_to_end
from tools.set_up import dependencies_of, read_project

from tfloom.rmw.cyclone.library import find_library

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "packages" / "tfloom-ddsc"
LICENSE = "cyclonedds-11.0.1.dist-info/licenses/LICENSE"


@pytest.fixture(scope="module")
def backend() -> ModuleType:
    spec = importlib.util.spec_from_file_location("build_backend", PACKAGE / "build_backend.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def write_wheel(folder: Path, platform: str, *libraries: str, content: bytes = b"a library") -> Path:
    path = folder / f"cyclonedds-11.0.1-cp313-cp313-{platform}.whl"
    with zipfile.ZipFile(path, "w") as wheel:
        wheel.writestr("cyclonedds/__init__.py", "import a_compiled_module")
        wheel.writestr("cyclonedds.libs/libcycloneddsidl-0123.so.11.0.1", b"another library")
        wheel.writestr(LICENSE, "EPL")
        for library in libraries:
            wheel.writestr(library, content)
    return path


@pytest.mark.parametrize(
    ("platform", "library"),
    [
        ("manylinux_2_27_x86_64.manylinux_2_28_x86_64", "cyclonedds.libs/libddsc-ad12c33a.so.11.0.1"),
        ("macosx_11_0_arm64", "cyclonedds/.dylibs/libddsc.11.0.1.dylib"),
        ("win_amd64", "cyclonedds.libs/ddsc.dll"),
    ],
)
def test_wheel_has_the_library_and_its_licence_for_any_python(
    backend: ModuleType, tmp_path: Path, platform: str, library: str
) -> None:
    wheel = backend.repack(write_wheel(tmp_path, platform, library), tmp_path)
    assert wheel.name == f"tfloom_ddsc-11.0.1-py3-none-{platform}.whl"
    with zipfile.ZipFile(wheel) as archive:
        info = "tfloom_ddsc-11.0.1.dist-info"
        names = ["tfloom_ddsc/__init__.py", f"tfloom_ddsc/{library.rpartition('/')[2]}"]
        assert archive.namelist() == [
            *names,
            *(f"{info}/{name}" for name in ("licenses/LICENSE", "METADATA", "WHEEL", "RECORD")),
        ]
        assert archive.read(names[1]) == b"a library"
        tags = [
            line for line in archive.read(f"{info}/WHEEL").decode().splitlines() if line.startswith("Tag")
        ]
        assert tags == [f"Tag: py3-none-{tag}" for tag in platform.split(".")]
        assert "Requires-Dist" not in archive.read(f"{info}/METADATA").decode()


@pytest.mark.parametrize(
    "libraries", [(), ("cyclonedds.libs/ddsc.dll", "cyclonedds/.dylibs/libddsc.1.dylib")]
)
def test_wheel_without_the_one_library_is_refused(
    backend: ModuleType, tmp_path: Path, libraries: tuple[str, ...]
) -> None:
    with pytest.raises(backend.BuildError, match=f"holds {len(libraries)} libraries named libddsc"):
        backend.repack(write_wheel(tmp_path, "any", *libraries), tmp_path)


@pytest.mark.wire
@pytest.mark.skipif(sys.platform != "linux", reason="strips a library of Linux")
def test_stripped_library_is_smaller_and_works(backend: ModuleType, tmp_path: Path) -> None:
    library = Path(find_library())
    wheel = write_wheel(tmp_path, "any", f"cyclonedds.libs/ddsc-{library.name}", content=library.read_bytes())
    with zipfile.ZipFile(backend.repack(wheel, tmp_path)) as archive:
        archive.extractall(tmp_path)
    (stripped,) = (tmp_path / "tfloom_ddsc").glob("ddsc-*")
    assert stripped.stat().st_size <= library.stat().st_size
    code = "import sys; from tfloom._native import test_dds_library; test_dds_library(sys.argv[1])"
    subprocess.run([sys.executable, "-c", code, stripped], check=True, timeout=60)


@pytest.mark.skipif(os.name != "posix", reason="the program is a script")
@pytest.mark.parametrize(
    ("library", "exit_code", "expected"),
    [
        (b"\x7fELF with symbols", 0, b"stripped \x7fELF with symbols"),
        (b"\x7fELF of another kind", 1, b"\x7fELF of another kind"),
        (b"MZ, a library of Windows", 0, b"MZ, a library of Windows"),
    ],
)
def test_libraries_of_linux_alone_are_stripped_and_stay_whole_if_that_fails(
    library: bytes,
    exit_code: int,
    expected: bytes,
    backend: ModuleType,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    program = tmp_path / "strip"
    program.write_text(
        f'#!/bin/sh\n{{ printf "stripped "; cat "$2"; }} > "$2.new" && mv "$2.new" "$2"\nexit {exit_code}\n'
    )
    program.chmod(0o755)
    monkeypatch.setattr(shutil, "which", lambda _: str(program))
    assert backend.stripped(library) == expected
    monkeypatch.setattr(shutil, "which", lambda _: None)
    assert backend.stripped(library) == library


def test_download_that_pip_calls_a_success_without_a_wheel_is_an_error(
    backend: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def run(command: list[str], **_: object) -> subprocess.CompletedProcess[str]:
        return subprocess.CompletedProcess(command, 0, "", "nothing to do")

    monkeypatch.setattr(subprocess, "run", run)
    with pytest.raises(backend.BuildError, match=r"no wheel of cyclonedds 11\.0\.1 came.*nothing to do"):
        backend.download(tmp_path)
    wheel = write_wheel(tmp_path, "any")
    assert backend.download(tmp_path) == wheel


def test_build_without_a_wheel_says_what_to_do(tmp_path: Path) -> None:
    done = run_to_end(
        [sys.executable, PACKAGE / "build_backend.py", tmp_path],
        env=os.environ | {"PIP_NO_INDEX": "1", "PIP_FIND_LINKS": ""},
    )
    assert done.returncode == 1
    assert "no wheel of cyclonedds 11.0.1 came for this platform" in done.stderr
    assert "apt-get install libddsc0t64" in done.stderr


def test_no_requirement_names_it() -> None:
    """It is on no index, where pip would search for it, and could get a stranger's."""
    for path in (ROOT / "pyproject.toml", *ROOT.glob("packages/*/pyproject.toml")):
        if path.parent != PACKAGE:
            assert '"tfloom-ddsc' not in path.read_text("utf-8"), path


@pytest.mark.parametrize(
    ("python", "system", "machine", "is_required"),
    [
        ("3.10", "linux", "x86_64", True),
        ("3.13", "linux", "x86_64", True),
        ("3.13", "darwin", "arm64", True),
        ("3.13", "win32", "AMD64", True),
        ("3.14", "linux", "x86_64", False),
        ("3.15", "linux", "x86_64", False),
        ("3.14", "darwin", "arm64", False),
        ("3.14", "win32", "AMD64", False),
        ("3.13", "linux", "aarch64", False),
        ("3.11", "linux", "armv7l", False),
    ],
)
def test_cyclonedds_is_required_only_where_it_has_a_wheel(
    python: str, system: str, machine: str, is_required: bool
) -> None:
    """Elsewhere pip would compile it, and fail."""
    here = {"python_version": python, "sys_platform": system, "platform_machine": machine}
    requirements = map(Requirement, dependencies_of(read_project(Path(sys.executable))))
    names = {
        requirement.name
        for requirement in requirements
        if requirement.marker is None or requirement.marker.evaluate(here)
    }
    assert ("cyclonedds" in names) == is_required
    assert "numpy" in names


@pytest.mark.parametrize(("libc", "is_required"), [("gnu", True), ("musl", False)])
def test_wheel_for_musl_requires_no_cyclonedds(libc: str, is_required: bool, tmp_path: Path) -> None:
    """It has no wheel there, and no marker of a requirement names musl."""
    code = (
        "import sys, sysconfig; sysconfig.get_config_vars()\n"  # which are read from a file of that name
        f"sys.implementation._multiarch = 'x86_64-linux-{libc}'\n"
        "from scikit_build_core.build import prepare_metadata_for_build_wheel\n"
        "print(prepare_metadata_for_build_wheel(sys.argv[1]))"
    )
    done = run_to_end([sys.executable, "-c", code, tmp_path], cwd=ROOT)
    assert done.returncode == 0, done.stdout + done.stderr
    metadata = (tmp_path / done.stdout.splitlines()[-1] / "METADATA").read_text("utf-8")
    required = set(re.findall(r"^Requires-Dist: ([\w.-]+)(?!.*extra ==)", metadata, re.MULTILINE))
    expected = {Requirement(text).name for text in dependencies_of(read_project(Path(sys.executable)))}
    assert required == expected - (set() if is_required else {"cyclonedds"})


@pytest.mark.slow
@pytest.mark.wire
def test_pip_builds_it_by_its_path(tmp_path: Path) -> None:
    """As README installs it; nodes of two processes then meet by it, without cyclonedds."""
    install = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--target", tmp_path, PACKAGE]
    done = run_to_end(install, timeout_s=300)
    assert done.returncode == 0, done.stdout + done.stderr
    done = run_to_end(
        [sys.executable, "-m", "tfloom", "doctor", "--report"], env=os.environ | {"PYTHONPATH": str(tmp_path)}
    )
    assert "libddsc 11.0.1 of tfloom-ddsc" in done.stdout, done.stdout + done.stderr
