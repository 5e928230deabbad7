"""Where the files of meshes are looked for: in packages, and around a description's file."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tfloom.viewer import mesh_places
from tfloom.viewer.mesh_places import find_mesh
from tfloom.viewer.shapes import DisplayError
from tfloom.workspace import packages_around

REST = Path("meshes", "a.stl")


def made(path: Path) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("solid a\nendsolid a\n")
    return path


def manifest(folder: Path, name: str) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "package.xml").write_text(f"<?xml version='1.0'?>\n<package><name> {name} </name></package>")


@pytest.mark.parametrize(
    ("mesh", "named"),
    [
        ("src/bot/meshes/a.stl", "bot"),  # the package that the description is in
        ("src/parts/meshes/a.stl", "parts"),  # one beside it
        ("src/checkout/meshes/a.stl", "bot_parts"),  # one whose manifest names it
        ("src/checkout/arms/meshes/a.stl", "arms"),  # one of another clone
        ("share/parts/meshes/a.stl", "parts"),  # one that is installed in the same prefix
        ("src/bot/meshes/a.stl", "renamed"),  # the description's own, under another name
        ("src/bot/urdf/meshes/a.stl", "bot"),  # beside the description
    ],
)
@pytest.mark.parametrize(
    "form", ["package://{}/meshes/a.stl", "package:///{}/meshes/a.stl", "model://{}/meshes/a.stl"]
)
def test_mesh_of_a_package_around_the_description(tmp_path: Path, mesh: str, named: str, form: str) -> None:
    near = tmp_path / "src" / "bot" / "urdf"
    near.mkdir(parents=True)
    manifest(tmp_path / "src" / "checkout", "bot_parts")
    manifest(tmp_path / "src" / "checkout" / "arms", "arms")
    path = made(tmp_path / mesh)
    assert find_mesh(form.format(named), near).resolve() == path.resolve()


def test_package_of_the_name_counts_before_a_folder_without(tmp_path: Path) -> None:
    near = tmp_path / "bot" / "urdf"
    made(near / REST)
    path = made(tmp_path / "parts" / REST)
    assert find_mesh("package://parts/meshes/a.stl", near) == path


@pytest.mark.parametrize("has_checkout", [False, True])
def test_installed_package_counts_before_what_is_above_the_description(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, has_checkout: bool
) -> None:
    path = made(tmp_path / "install" / "gripper" / REST)
    monkeypatch.setattr(mesh_places, "get_package_share_path", lambda _: tmp_path / "install" / "gripper")
    made(tmp_path / "src" / "bot" / REST)  # of the same name, of another package
    if has_checkout:
        (tmp_path / "src" / "gripper").mkdir()  # its meshes are only in what was installed
    assert find_mesh("package://gripper/meshes/a.stl", tmp_path / "src" / "bot" / "urdf") == path


def test_file_of_another_machine_is_found_in_its_package_around_the_description(tmp_path: Path) -> None:
    path = made(tmp_path / "arm" / REST)
    near = tmp_path / "arm" / "urdf"
    near.mkdir()
    gone = f"file:///home/somebody/share/install/share/arm/{REST.as_posix()}"
    assert find_mesh(gone, near) == path
    # One that is there is taken as it is named; and what came over the wire has nothing around it.
    here = made(tmp_path / "install" / "share" / "arm" / REST)
    assert find_mesh(here.as_uri(), near) == here
    assert find_mesh(gone, None) == Path(gone.removeprefix("file://"))
    for absent in ("file:///share/arm/meshes/b.stl", "file:///share/leg/meshes/a.stl", "file:///share.stl"):
        assert find_mesh(absent, near) == Path(absent.removeprefix("file://"))


def test_paths_of_a_file_are_beside_it(tmp_path: Path) -> None:
    assert find_mesh("meshes/a.stl", tmp_path) == tmp_path / REST
    assert find_mesh("../a.STL", tmp_path) == tmp_path / ".." / "a.STL"
    assert find_mesh(f"{tmp_path}/b.dae", Path("/elsewhere")) == tmp_path / "b.dae"
    assert find_mesh("file:///a%20b.stl", None) == Path("/a b.stl")


@pytest.mark.parametrize(
    ("uri", "why"),
    [
        ("meshes/a.stl", "begins neither with package:// nor with file://"),
        ("package://nowhere/a.stl", "there is no package 'nowhere', which package://nowhere/a.stl is in"),
        ("package://../a.stl", "there is no package '..'"),
        ("file:///etc/passwd", "is not a file of a mesh"),
        ("file://[x.stl", "is not a URI"),
        ("http://host/a.stl", "begins neither"),
    ],
)
def test_what_came_over_the_wire_names_packages_and_files_alone(uri: str, why: str) -> None:
    with pytest.raises(DisplayError) as caught:
        find_mesh(uri, None)
    assert why in str(caught.value)


def test_package_that_is_nowhere_is_said_with_the_folder(tmp_path: Path) -> None:
    for uri in ("package://nowhere/a.stl", "package://../a.stl", "package://a%2Fb/a.stl"):
        with pytest.raises(DisplayError, match=f"and none around {tmp_path}"):
            find_mesh(uri, tmp_path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes with names")
def test_manifests_that_are_none_are_passed_over(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(packages_around, "MAX_MANIFEST_BYTES", 100)
    near = tmp_path / "bot"
    near.mkdir()
    (tmp_path / "pipe").mkdir()
    os.mkfifo(tmp_path / "pipe" / "package.xml")
    (tmp_path / "zero").mkdir()
    (tmp_path / "zero" / "package.xml").symlink_to("/dev/zero")
    manifest(tmp_path / "long", "parts")
    with (tmp_path / "long" / "package.xml").open("a") as file:
        file.write(" " * 100)
    manifest(tmp_path / "right", "parts")
    path = made(tmp_path / "right" / REST)
    made(tmp_path / "long" / REST)
    assert find_mesh("package://parts/meshes/a.stl", near) == path
