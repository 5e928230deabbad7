"""A new package for a workspace: Python, built by colcon (build type ament_python)."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple
from xml.sax.saxutils import escape

_PACKAGE_XML = """\
<?xml version="1.0"?>
<?xml-model href="http://download.ros.org/schema/package_format3.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="3">
  <name>{name}</name>
  <version>0.0.0</version>
  <description>{description}</description>
  <maintainer email="{email}">{maintainer}</maintainer>
  <license>{license}</license>

{depends}  <export>
    <build_type>ament_python</build_type>
  </export>
</package>
"""

_SETUP_PY = """\
from setuptools import find_packages, setup

package_name = "{name}"

setup(
    name=package_name,
    version="0.0.0",
    packages=find_packages(exclude=["test"]),
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{{package_name}}"]),
        (f"share/{{package_name}}", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer={maintainer!r},
    maintainer_email={email!r},
    description={description!r},
    license={license!r},
    entry_points={{
        "console_scripts": [
{scripts}        ],
    }},
)
"""

_SETUP_CFG = """\
[develop]
script_dir=$base/lib/{name}
[install]
install_scripts=$base/lib/{name}
"""

_NODE = '''\
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class {class_name}(Node):
    """Counts the seconds."""

    def __init__(self):
        super().__init__("{node}")
        self.count = 0
        self.timer = self.create_timer(1.0, self.on_timer)
        self.get_logger().info("Hi from {name}.")

    def on_timer(self):
        self.count += 1
        self.get_logger().info(f"{{self.count}} s")


def main():
    rclpy.init()
    node = {class_name}()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
'''


class Package(NamedTuple):
    """The description of a new package."""

    name: str
    description: str = "TODO: Package description"
    license: str = "TODO: License declaration"
    maintainer: str = "TODO"
    email: str = "todo@example.com"
    dependencies: tuple[str, ...] = ()
    node: str | None = None
    """Name of a first node; its program has the same name."""


def create_package(package: Package, folder: Path) -> list[Path]:
    """Write a package into `folder/<name>` and return its files.

    Raises:
        FileExistsError: the folder exists.
        ValueError: a name is not a valid one of a package, a node or a dependency.
    """
    check_name(package.name, "package")
    if package.node is not None:
        check_name(package.node, "node")
    if package.name == "test":
        raise ValueError("'test' can't be a package's name: its code would be where its tests go")
    for dependency in package.dependencies:
        if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_-]*", dependency):
            raise ValueError(f"'{dependency}' can't be a package to depend on")
    root = folder / package.name
    root.mkdir(parents=True)
    written = []
    for path, text in _files(package):
        target = root / path
        target.parent.mkdir(exist_ok=True)
        target.write_text(text, "utf-8")
        written.append(target)
    return written


def check_name(name: str, what: str) -> None:
    """Check that a name is valid for a Python module.

    Raises:
        ValueError: it doesn't begin with a lower-case letter, has characters other than those, digits and
            underscores, or is a keyword.
    """
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name) or keyword.iskeyword(name):
        raise ValueError(
            f"'{name}' can't be a {what}'s name: use lower-case letters, digits and underscores, a letter first"
        )


def _files(package: Package) -> Iterable[tuple[str, str]]:
    name = package.name
    depends = dict.fromkeys([*(["rclpy"] if package.node else []), *package.dependencies])
    texts = {field: escape(getattr(package, field), {'"': "&quot;"}) for field in package._fields[:5]}
    tags = "".join(f"  <depend>{escape(each)}</depend>\n" for each in depends)
    yield "package.xml", _PACKAGE_XML.format(**texts, depends=f"{tags}\n" if tags else "")
    script = f'            "{package.node} = {name}.{package.node}:main",\n' if package.node else ""
    yield "setup.py", _SETUP_PY.format(**package._asdict(), scripts=script)
    yield "setup.cfg", _SETUP_CFG.format(name=name)
    yield f"resource/{name}", ""
    yield f"{name}/__init__.py", ""
    if package.node:
        class_name = "".join(part.capitalize() for part in package.node.split("_"))
        yield f"{name}/{package.node}.py", _NODE.format(name=name, node=package.node, class_name=class_name)
