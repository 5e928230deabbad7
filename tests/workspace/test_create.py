"""New packages: the written files, and rejected names."""

from __future__ import annotations

import os
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from ament_package.templates import IS_WINDOWS, configure_file, configure_string

from tfloom.workspace.cmake_lists import read_plan
from tfloom.workspace.create import Package, create_package
from tfloom.workspace.licenses import LICENSES, License, find_license, find_license_text


def test_package_with_a_node_is_written(tmp_path: Path) -> None:
    package = Package(
        "my_pkg", 'a "quoted" <text> & more', "MIT", "O'Neil \u00e9", "o@example.com", ("tf2_ros",), "my_node"
    )
    written = create_package(package, tmp_path / "src")
    names = [path.relative_to(tmp_path / "src").as_posix() for path in written]
    assert names == [
        "my_pkg/package.xml",
        "my_pkg/LICENSE",
        "my_pkg/setup.py",
        "my_pkg/setup.cfg",
        "my_pkg/resource/my_pkg",
        "my_pkg/my_pkg/__init__.py",
        "my_pkg/my_pkg/my_node.py",
        "my_pkg/test/test_copyright.py",
        "my_pkg/test/test_flake8.py",
        "my_pkg/test/test_pep257.py",
    ]
    assert "Permission is hereby granted" in written[1].read_text("utf-8")
    xml = ET.parse(written[0]).getroot()
    assert xml.findtext("description") == package.description
    assert xml.findtext("maintainer") == package.maintainer
    assert [tag.text for tag in xml.findall("depend")] == ["rclpy", "tf2_ros"]
    for path in written:
        if path.suffix == ".py":
            compile(path.read_text("utf-8"), path, "exec")
    assert "'my_node = my_pkg.my_node:main'" in written[2].read_text("utf-8")


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


def test_interface_package_is_written(tmp_path: Path) -> None:
    package = Package(
        "my_msgs", license="Apache-2.0", dependencies=("geometry_msgs",), build_type="ament_cmake"
    )
    written = create_package(package, tmp_path)
    names = [path.relative_to(tmp_path / "my_msgs").as_posix() for path in written]
    assert names == ["package.xml", "LICENSE", "CMakeLists.txt", "msg/Num.msg"]
    xml = ET.parse(written[0]).getroot()
    assert xml.findtext("member_of_group") == "rosidl_interface_packages"
    assert xml.findtext("export/build_type") == "ament_cmake"
    plan = read_plan(tmp_path / "my_msgs", tmp_path)
    assert (plan.interfaces, plan.dependencies) == (["msg/Num.msg"], ["geometry_msgs"])
    assert plan.unknown == []


def test_library_is_written(tmp_path: Path) -> None:
    written = create_package(Package("my_pkg", library="my_lib"), tmp_path)
    assert tmp_path / "my_pkg" / "my_lib" / "__init__.py" in written


@pytest.mark.parametrize("licence", LICENSES)
def test_license_has_its_text(licence: License) -> None:
    text = find_license_text(licence.spdx)
    assert text
    assert find_license_text("Unheard-Of") is None
    granting = {"apache2": "APPENDIX", "gplv3": "GNU GENERAL", "lgplv3": "GNU LESSER"}
    assert (
        granting[licence.name] in text
        if licence.name in granting
        else find_license(text) in {licence.name, None}
    )


@pytest.mark.parametrize(
    ("template", "text"),
    [
        ("a=@FOO@", "a=x"),
        ("a=@FOO@;b=@BAR@", "a=x;b="),
        ("@FOO@-@foo_2@-@FOO@", "x-y-x"),
        ("name@host, @a b@, @@", "name@host, @a b@, @@"),
        ("", ""),
    ],
)
def test_variables_are_replaced(template: str, text: str) -> None:
    assert configure_string(template, {"FOO": "x", "foo_2": "y"}) == text


def test_values_are_not_replaced_again() -> None:
    assert configure_string("@A@@B@", {"A": "@B@", "B": "\\1"}) == "@B@\\1"


def test_file_is_read_as_utf_8(tmp_path: Path) -> None:
    path = tmp_path / "setup.sh.in"
    path.write_text("prefix=@P@ # ü\n", encoding="utf-8")
    assert configure_file(str(path), {"P": "/opt"}) == "prefix=/opt # ü\n"
    with pytest.raises(FileNotFoundError):
        configure_file(tmp_path / "none", {})


def test_is_windows_is_of_this_platform() -> None:
    assert IS_WINDOWS is (os.name == "nt")
