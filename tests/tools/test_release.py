"""The files of a release: built, checked, and installed where there is no compiler; the workflows that build them."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tarfile
import time
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import FIGURE, run_to_end
from tests.wheels import release_files, release_tools, wheel_of
from tools import release
from tools.release import MAX_WHEEL_SIZE, Tools
from tools.set_up import SetUpError, read_project

import tfloom

ROOT = Path(__file__).parents[2]
GITHUB = ROOT / ".github"
PLATFORMS = {
    "linux": {"manylinux_x86_64", "manylinux_aarch64", "musllinux_x86_64", "musllinux_aarch64"},
    "macos": {"macosx_x86_64", "macosx_arm64"},
    "windows": {"win_amd64"},
}
PYTHONS = {"cp310", "cp311", "cp312", "cp313", "cp314", "cp314t"}
RUNNERS = ["ubuntu-24.04", "ubuntu-24.04-arm", "macos-15-intel", "macos-14", "windows-2022"]


@pytest.fixture(scope="module")
def tools(tmp_path_factory: pytest.TempPathFactory) -> Tools:
    return release_tools(tmp_path_factory)


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    return release_files(tmp_path_factory)


@pytest.mark.slow
def test_files_are_complete_and_pass_the_checks(tools: Tools, files: list[Path]) -> None:
    names = {re.split(r"-(?=\d)", path.name)[0] for path in files}
    assert names == {"tfloom", "tfloom_ros2", "tfloom_rviz", "tfloom_interfaces", "tfloom_sensing"}
    assert len(files) == 10
    assert all(f"-{tfloom.__version__}" in path.name for path in files)
    release.check(tools, files)


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="auditwheel is for Linux")
def test_wheel_names_its_c_library_and_is_small(
    files: list[Path], record_property: Callable[[str, str], None]
) -> None:
    wheel = wheel_of(files, "tfloom")
    assert re.search(r"-(many|musl)linux_\d+_\d+_", wheel.name)
    record_property(FIGURE, release.report(files))
    assert wheel.stat().st_size < MAX_WHEEL_SIZE
    with zipfile.ZipFile(wheel) as content:
        names = content.namelist()
    assert "tfloom.pth" in names
    example = {path.name for path in (ROOT / "examples" / "robot_in_a_room").iterdir() if path.is_file()}
    folder = "tfloom/demos/robot_in_a_room/"
    assert {name.removeprefix(folder) for name in names if name.startswith(folder)} - {""} == example
    assert {Path(name).name for name in names if "/licenses/" in name} >= {
        "LICENSE",
        "nanobind.txt",
        "robin-map.txt",
        "uplot.txt",
    }


@pytest.mark.slow
def test_each_wheel_holds_the_licence(files: list[Path]) -> None:
    text = (ROOT / "LICENSE").read_bytes()
    for wheel in (path for path in files if path.suffix == ".whl"):
        with zipfile.ZipFile(wheel) as content:
            (name,) = (entry for entry in content.namelist() if entry.endswith(".dist-info/licenses/LICENSE"))
            assert content.read(name) == text, wheel.name


@pytest.mark.slow
def test_sdist_holds_what_a_build_needs_alone(files: list[Path]) -> None:
    (sdist,) = (path for path in files if path.name.startswith("tfloom-") and path.name.endswith(".tar.gz"))
    with tarfile.open(sdist) as archive:
        names = [name for name in archive.getnames() if "/" in name]
        (info,) = (name for name in names if name.count("/") == 1 and name.endswith("/PKG-INFO"))
        file = archive.extractfile(info)
        assert file is not None
        metadata = file.read().decode()
    assert "\nDynamic: Requires-Dist\n" in metadata  # a wheel for musl requires less
    assert "\nRequires-Dist: numpy>=" in metadata
    tops = {name.split("/")[1] for name in names}
    expected = {
        "CHANGELOG.md",
        "CMakeLists.txt",
        "LICENSE",
        "PKG-INFO",
        "README.md",
        "examples",  # that which `tfloom demo robot` runs
        "licenses",
        "native",
        "pyproject.toml",
        "src",
        "tools",  # the build backend, what it looks for a compiler with, and what writes the requirements of a wheel
    }
    assert tops == expected
    tools = {
        name.split("/", 2)[2] for name in names if name.split("/")[1:2] == ["tools"] and name.count("/") > 1
    }
    assert tools == {"build_backend.py", "set_up.py", "wheel_requirements.py"}
    examples = {
        name.split("/")[2] for name in names if name.split("/")[1:2] == ["examples"] and name.count("/") > 2
    }
    assert examples == {"robot_in_a_room"}


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="the places of commands are POSIX's")
def test_wheel_runs_the_demo_without_a_compiler(
    files: list[Path], domain_id: int, tmp_path: Path, record_property: Callable[[str, str], None]
) -> None:
    subprocess.run([sys.executable, "-m", "venv", tmp_path / "venv"], check=True, timeout=120)
    commands = tmp_path / "venv" / "bin"
    variables = {
        name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "AMENT"))
    }
    environment = variables | {
        "PATH": str(commands),
        "ROS_DOMAIN_ID": str(domain_id),
        "CC": "none",
        "CXX": "none",
    }
    assert not [
        name
        for name in ("cc", "c++", "gcc", "g++", "clang", "cmake")
        if shutil.which(name, path=str(commands))
    ]
    wheels = [
        wheel_of(files, name) for name in ("tfloom", "tfloom_ros2", "tfloom_interfaces", "tfloom_sensing")
    ]
    started = time.monotonic()
    run([commands / "pip", "install", "--quiet", "--only-binary", ":all:", *wheels], tmp_path, environment)
    took_s = time.monotonic() - started
    record_property(FIGURE, f"`pip install` of the wheels and of what they need: {took_s:.1f} s")
    output = run([commands / "tfloom", "demo", "--seconds", "5"], tmp_path, environment)
    assert "Translation" in output
    assert (tmp_path / "frames.pdf").read_bytes().startswith(b"%PDF")
    assert (tmp_path / "turtles.png").read_bytes().startswith(b"\x89PNG")
    assert "ros2 (tfloom)" in run([commands / "ros2", "--version"], tmp_path, environment)
    without_opencv = (
        "import cv_bridge, image_geometry, diagnostic_updater, interactive_markers, numpy\n"
        "try: cv_bridge.CvBridge().cv2_to_compressed_imgmsg(numpy.zeros((2, 2), 'uint8'))\n"
        "except ModuleNotFoundError as error: print(error)"
    )
    output = run([commands / "python", "-c", without_opencv], tmp_path, environment)
    assert output.endswith("is not installed: pip install opencv-python-headless\n")


def run(command: list[Path | str], cwd: Path, environment: dict[str, str]) -> str:
    """Run an installed command and return its output; fail with it."""
    done = run_to_end(command, cwd=cwd, env=environment, timeout_s=300)
    assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
    return done.stdout


@pytest.mark.slow
@pytest.mark.parametrize("platform", PLATFORMS)
def test_wheels_are_configured_for_each_platform(tools: Tools, platform: str) -> None:
    command = ["--platform", platform, "--archs", "all", "--print-build-identifiers", "."]
    identifiers = set(tools.run("cibuildwheel", *command).split())
    missing = {f"{python}-{system}" for python in PYTHONS for system in PLATFORMS[platform]} - identifiers
    assert not missing
    assert {name.split("-")[0] for name in identifiers} == PYTHONS


@pytest.mark.slow
def test_workflows_and_forms_fit_their_schemas(tools: Tools) -> None:
    forms = [path for path in sorted((GITHUB / "ISSUE_TEMPLATE").glob("*.yml")) if path.name != "config.yml"]
    for schema, paths in (
        ("github-workflows", sorted((GITHUB / "workflows").glob("*.yml"))),
        ("github-issue-forms", forms),
        ("github-issue-config", [GITHUB / "ISSUE_TEMPLATE" / "config.yml"]),
    ):
        assert "ok" in tools.run("check-jsonschema", "--builtin-schema", f"vendor.{schema}", *paths)


def test_the_workflow_builds_on_each_system_and_stores_no_token() -> None:
    text = (GITHUB / "workflows" / "wheels.yml").read_text("utf-8")
    assert [runner for runner in RUNNERS if f"          - {runner}" not in text] == []
    publish = text.partition("\n  publish:")[2]
    assert "needs: [wheels, sources]" in publish
    assert '--check-tag "$TAG"' in text.partition("\n  sources:")[2].partition("\n  publish:")[0]
    first, _, beside = publish.partition("\n  publish-beside:")
    assert "needs: publish\n" in beside
    assert "environment: pypi-tfloom\n" in first
    assert "environment: pypi-${{ matrix.project }}\n" in beside
    assert "startsWith(github.ref, 'refs/tags/v')" in publish
    assert "id-token: write" in publish
    assert "secrets." not in text
    assert not re.search(r"password|token:(?! write)", text)


def test_what_tests_a_wheel_is_the_core_tier_of_the_matrix() -> None:
    command = read_project(Path(sys.executable))["tool"]["cibuildwheel"]["test-command"]
    (core,) = re.findall(r'^core="(.*)"$', (ROOT / ".ci" / "matrix").read_text("utf-8"), re.MULTILINE)
    assert command.endswith(core)
    assert all((ROOT / path).exists() for path in core.split())


def test_the_distributions_have_one_version(monkeypatch: pytest.MonkeyPatch) -> None:
    versions = release.versions()
    assert len(versions) == 8  # of five projects, and what three of them require
    assert set(versions.values()) == {tfloom.__version__}
    release.check_tag(f"v{tfloom.__version__}")
    for tag in (tfloom.__version__, f"v{tfloom.__version__}.post1", "v"):
        with pytest.raises(SetUpError, match="differs from versions"):
            release.check_tag(tag)
    monkeypatch.setattr(
        release, "versions", lambda: versions | {"packages/tfloom-ros2/pyproject.toml": "0.0.9"}
    )
    with pytest.raises(SetUpError, match=r"tfloom-ros2/pyproject.toml: 0\.0\.9"):
        release.check_tag(f"v{tfloom.__version__}")


def test_the_changes_of_this_version_are_listed() -> None:
    text = (ROOT / "CHANGELOG.md").read_text("utf-8")
    headings = re.findall(r"^## (\d+\.\d+\.\d+)", text, re.MULTILINE)
    assert headings[0] == tfloom.__version__
    assert re.findall(r"^### (.+)$", text.split("\n## ")[1], re.MULTILINE)
