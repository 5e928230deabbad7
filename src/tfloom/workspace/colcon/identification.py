"""Which packages are built without CMake, and which can't be built at all."""

from __future__ import annotations

import os
from pathlib import Path

from catkin_pkg.package import InvalidPackage, parse_package
from colcon_core.package_descriptor import PackageDescriptor
from colcon_core.package_identification import PackageIdentificationExtensionPoint
from colcon_ros.package_identification.ros import get_package_with_build_type

from tfloom.ros_imports.ros_distro import set_ros_environment
from tfloom.workspace.missing_dependencies import IGNORE_MARKERS
from tfloom.workspace.package_faults import find_manifest_fault, find_setup_fault, name_in_manifest

READ_TYPE = "ros.tfloom"
"""The type of a package whose CMakeLists.txt is read."""
BROKEN_TYPE = "tfloom.broken"
"""The type of a package that can't be built; without the prefix `ros.`, because its package.xml may be broken."""
FAULT_KEY = "tfloom_fault"
"""The key of the fault in the metadata of such a package's descriptor."""


class Identification(PackageIdentificationExtensionPoint):
    """Identify packages of build type `ament_cmake` that need no CMake, and broken ones."""

    PRIORITY = 160  # above that of colcon-ros

    def __init__(self) -> None:
        super().__init__()
        set_ros_environment()  # conditions in package.xml ask for it: `condition="$ROS_VERSION == 2"`

    def identify(self, desc: PackageDescriptor) -> None:
        """Set type and name of a package that is built here; leave the others to colcon-ros."""
        manifest = desc.path / "package.xml"
        if desc.type is not None or not manifest.is_file() or _is_ignored(desc.path):
            return
        fault = find_manifest_fault(manifest) or _find_invalid_value(manifest)
        if fault is not None:
            _mark_as_broken(desc, name_in_manifest(manifest), fault)
            return
        package, build_type = get_package_with_build_type(str(desc.path))
        if build_type == "ament_cmake" and not has_real_ament_cmake():
            desc.type = READ_TYPE
            desc.name = desc.name or package.name
        elif build_type == "ament_python":
            fault = find_setup_fault(desc.path / "setup.py")
            if fault is not None:
                _mark_as_broken(desc, package.name, fault)
        elif build_type == "catkin" and not (desc.path / "CMakeLists.txt").is_file():
            fault = f"{manifest}: a build type is missing: add <export><build_type>ament_python</build_type></export>"
            _mark_as_broken(desc, package.name, fault)


def _find_invalid_value(manifest: Path) -> str | None:
    """Return what catkin_pkg finds wrong with a package.xml, or None; what is not a package's has no fault."""
    if b"<package" not in manifest.read_bytes():
        return None
    try:
        parse_package(str(manifest), warnings=[])
    except (InvalidPackage, AssertionError) as error:
        reason = str(getattr(error, "msg", error))
        return f"{manifest}: {'; '.join(reason.splitlines())}"
    return None


def has_real_ament_cmake() -> bool:
    """Return whether a ROS with ament_cmake is sourced, which then builds its packages itself."""
    prefixes = [
        prefix
        for variable in ("AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH")
        for prefix in os.environ.get(variable, "").split(os.pathsep)
        if prefix
    ]
    return any(Path(prefix, "share", "ament_cmake", "cmake").is_dir() for prefix in prefixes)


def _is_ignored(folder: Path) -> bool:
    return any((folder / marker).exists() for marker in IGNORE_MARKERS)


def _mark_as_broken(desc: PackageDescriptor, name: str, fault: str) -> None:
    desc.type = BROKEN_TYPE
    desc.name = desc.name or name
    desc.metadata[FAULT_KEY] = fault
