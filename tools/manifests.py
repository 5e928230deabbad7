"""The generator of the `package.xml` of each package that tfloom stands for.

Programs ask for a package's share folder, and read this file in it: `FindPackageShare`, `ros2 pkg xml`.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from xml.sax.saxutils import escape

from tools.facades.rooms import ROOT
from tools.facades.table import read_table

from tfloom import __version__
from tfloom.workspace.index import NAMED_OTHERWISE, PROGRAMS

__all__ = ["generate_all"]

_DEFINITIONS = {
    "src/tfloom/rosidl/definitions": "src/tfloom",
    "packages/tfloom-interfaces/src/tfloom_interfaces/definitions": "packages/tfloom-interfaces/src/tfloom_interfaces",
}
"""The folders of definitions, each with the prefix of its packages."""
_OF_PROGRAMS = {
    "demo_nodes_cpp": "Demonstration nodes, of which the original's are in C++.",
    "foxglove_bridge": "A server of the graph for Foxglove and Lichtblick.",
    "joint_state_publisher_gui": "The page with a slider for each joint of a robot.",
    "rmw_zenoh_cpp": "The router of the Zenoh wire.",
    "robot_state_publisher": "The frames of a robot, by its description and the states of its joints.",
    "rqt_console": "The page that stands in for the log's window.",
    "rqt_graph": "The page that stands in for the graph's window.",
    "rqt_plot": "The page that stands in for the plots' window.",
    "rviz2": "The page that stands in for RViz.",
    "turtle_tf2_py": "Demonstration of tf2 with turtlesim.",
    "turtlesim": "A simulator of turtles, with its messages, services and actions.",
    "xacro": "Macros in XML, for descriptions of robots.",
}
"""What is in the packages that have programs, and no façade whose docstring says it."""


def generate_all() -> dict[str, str]:
    """Return the files, by path within the repository."""
    files = {}
    for folder, name in _folders_of_definitions():
        description = _OF_PROGRAMS.get(name, f"Messages, services and actions of {name}.")
        manifest = _manifest(name, description, has_interfaces=True)
        # The second, because programs also make the path themselves, of a prefix.
        files[f"{folder}/{name}/package.xml"] = manifest
        files[f"{_DEFINITIONS[folder]}/share/{name}/package.xml"] = manifest
    with_definitions = {name for _, name in _folders_of_definitions()}
    others = {
        name: (Path(package.folder).parent, package.modules[name].doc)
        for name, package in read_table().items()
    }
    others |= {name: (Path("src/tfloom"), others[module][1]) for name, module in NAMED_OTHERWISE.items()}
    of_programs = {
        name: (Path("src/tfloom"), _OF_PROGRAMS[name]) for name in {*PROGRAMS} - {*others} - with_definitions
    }
    for name, (prefix, description) in sorted((others | of_programs).items()):
        if name not in with_definitions:
            path = f"{prefix.as_posix()}/share/{name}/package.xml"
            files[path] = _manifest(name, description, has_interfaces=False)
    return files


def _folders_of_definitions() -> Iterator[tuple[str, str]]:
    for folder in _DEFINITIONS:
        yield from ((folder, path.name) for path in sorted((ROOT / folder).iterdir()) if path.is_dir())


def _manifest(name: str, description: str, *, has_interfaces: bool) -> str:
    group = "  <member_of_group>rosidl_interface_packages</member_of_group>\n" if has_interfaces else ""
    build_type = "ament_cmake" if has_interfaces else "ament_python"
    first_line = description.splitlines()[0]
    return (
        '<?xml version="1.0"?>\n'
        '<package format="3">\n'
        f"  <name>{name}</name>\n"
        f"  <version>{__version__}</version>\n"
        f"  <description>{escape(first_line)} Provided by tfloom.</description>\n"
        '  <maintainer email="tfloom@example.org">The tfloom developers</maintainer>\n'
        "  <license>Apache-2.0</license>\n"
        f"{group}"
        "  <export>\n"
        f"    <build_type>{build_type}</build_type>\n"
        "  </export>\n"
        "</package>\n"
    )
