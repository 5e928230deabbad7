"""New packages: the written files, and rejected names."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from tfloom.workspace.create import Package, create_package


def test_package_with_a_node_is_written(tmp_path: Path) -> None:
    package = Package(
        "my_pkg", 'a "quoted" <text> & more', "MIT", "O'Neil \u00e9", "o@example.com", ("tf2_ros",), "my_node"
    )
    written = create_package(package, tmp_path / "src")
    names = [path.relative_to(tmp_path / "src").as_posix() for path in written]
    assert names == [
        "my_pkg/package.xml",
        "my_pkg/setup.py",
        "my_pkg/setup.cfg",
        "my_pkg/resource/my_pkg",
        "my_pkg/my_pkg/__init__.py",
        "my_pkg/my_pkg/my_node.py",
    ]
    xml = ET.parse(written[0]).getroot()
    assert xml.findtext("description") == package.description
    assert xml.findtext("maintainer") == package.maintainer
    assert [tag.text for tag in xml.findall("depend")] == ["rclpy", "tf2_ros"]
    for path in written:
        if path.suffix == ".py":
            compile(path.read_text("utf-8"), path, "exec")
    assert '"my_node = my_pkg.my_node:main"' in written[1].read_text("utf-8")


def test_package_without_a_node_is_written(tmp_path: Path) -> None:
    written = create_package(Package("my_pkg"), tmp_path)
    assert ET.parse(written[0]).getroot().findall("depend") == []
    assert not any(path.name.endswith("_node.py") for path in written)


@pytest.mark.parametrize("name", ["", "My", "1a", "a-b", "a b", "../a", "import", "_a"])
def test_name_that_python_cannot_import_is_rejected(name: str, tmp_path: Path) -> None:
    for package in (Package(name), Package("good", node=name or " ")):
        with pytest.raises(ValueError, match="name: use lower-case letters"):
            create_package(package, tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_existing_folder_is_not_changed(tmp_path: Path) -> None:
    (tmp_path / "my_pkg").mkdir()
    with pytest.raises(FileExistsError):
        create_package(Package("my_pkg"), tmp_path)
    assert list((tmp_path / "my_pkg").iterdir()) == []
