"""Textures of robots: on meshes that have coordinates for them, and files that are absent, hostile or no pictures."""

from __future__ import annotations

import io
import os
import struct
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from PIL import Image
from tests.viewer.test_robot_model import BOX, link_of, loaded

from tfloom.viewer import mesh_files, pictures, shapes, textures
from tfloom.viewer.displays import robot_model
from tfloom.viewer.mesh_files import read_model
from tfloom.viewer.shapes import DisplayError
from tfloom.viewer.textures import Texture, read_texture

S = 1_000_000_000
ONE = (1.0, 1.0, 1.0)
RED, BLUE = (200, 10, 20), (10, 20, 200)
QUAD = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"
"""A square with the whole picture on it."""


@pytest.fixture(autouse=True)
def nothing_kept() -> Iterator[None]:
    for kept in (mesh_files._kept, textures._kept):
        kept.clear()
    yield
    for kept in (mesh_files._kept, textures._kept):
        kept.clear()


def write_halves(path: Path, size: int = 8) -> Path:
    """Write a picture whose left half is red, and whose right half is blue."""
    pixels = np.zeros((size, size, 3), np.uint8)
    pixels[:, : size // 2], pixels[:, size // 2 :] = RED, BLUE
    Image.fromarray(pixels).save(path)
    return path


def write_plain(path: Path) -> Path:
    Image.new("RGB", (4, 4), RED).save(path)
    return path


def write_ball(path: Path) -> None:
    trimesh.creation.icosphere(subdivisions=0).export(path)


def opened(glb: bytes) -> Any:
    return trimesh.load(io.BytesIO(glb), file_type="glb", force="mesh")


def colors_by_x(glb: bytes) -> dict[float, tuple[int, ...]]:
    """Return which colour of the texture the vertices at each x have."""
    mesh = opened(glb)
    picture = np.asarray(mesh.visual.material.baseColorTexture.convert("RGB"))
    high, wide = picture.shape[:2]
    colors = {}
    for (x, _, _), (u, v) in zip(mesh.vertices, mesh.visual.uv, strict=True):
        row, column = int(np.clip((1.0 - v) * high, 0, high - 1)), int(np.clip(u * wide, 0, wide - 1))
        colors[round(float(x), 3)] = tuple(picture[row, column].tolist())
    return colors


def robot(mesh: str, material: str, collision: str = "") -> str:
    """Return a robot of one link, which has a mesh with a material."""
    visual = f"<visual><geometry>{mesh}</geometry><material name='m'>{material}</material></visual>"
    collision = collision and f"<collision><geometry>{collision}</geometry></collision>"
    return f'<robot name="r"><link name="a">{visual}{collision}</link></robot>'


def textured(name: str, color: str = "") -> str:
    return color + f'<texture filename="{name}"/>'


MESH_OBJ, MESH_STL = '<mesh filename="a.obj"/>', '<mesh filename="a.stl"/>'


def test_texture_is_on_the_coordinates_of_each_format_that_has_them(tmp_path: Path) -> None:
    texture = read_texture(str(write_halves(tmp_path / "halves.png")), tmp_path)
    (tmp_path / "a.obj").write_text(QUAD)
    quad: Any = trimesh.load(tmp_path / "a.obj", force="mesh")
    for ending in ("glb", "dae", "ply"):
        quad.export(tmp_path / f"a.{ending}")
    for ending in ("obj", "glb", "dae", "ply"):
        model = read_model(f"file://{tmp_path}/a.{ending}", ONE, texture=texture)
        assert model.has_texture, ending
        assert colors_by_x(model.glb) == {0.0: RED, 1.0: BLUE}, ending


def test_parts_of_a_scene_have_the_texture_where_each_is_and_outside_of_the_picture_it_repeats(
    tmp_path: Path,
) -> None:
    """The file's own materials are not mixed with it, and no coordinate is cut."""
    texture = read_texture(str(write_halves(tmp_path / "halves.png")), tmp_path)
    scene = trimesh.Scene()
    for number, color in enumerate(((0, 255, 0, 255), (255, 255, 0, 255))):
        part = trimesh.Trimesh([[0, 0, 0], [1, 0, 0], [0, 0, 1]], [[0, 1, 2]], process=False)
        material = trimesh.visual.material.PBRMaterial(baseColorFactor=color)
        uv = np.array([[0.0, 0.0], [3.0, 0.0], [0.0, -2.0]])
        part.visual = trimesh.visual.TextureVisuals(uv=uv, material=material)
        scene.add_geometry(part, transform=trimesh.transformations.translation_matrix((10.0 * number, 0, 0)))
    bare = trimesh.creation.box((1, 1, 1))
    scene.add_geometry(bare, transform=trimesh.transformations.translation_matrix((20.0, 0, 0)))
    scene.export(tmp_path / "a.glb")
    model = read_model(f"file://{tmp_path}/a.glb", ONE, texture=texture)
    mesh = opened(model.glb)
    assert mesh.bounds[:, 0].tolist() == [0.0, 20.5]
    table = {
        round(float(x), 3): uv.tolist()
        for (x, _, z), uv in zip(mesh.vertices, mesh.visual.uv, strict=True)
        if not z
    }
    assert table[0.0] == table[10.0] == pytest.approx([0.0, 0.0])
    assert table[1.0] == table[11.0] == pytest.approx([3.0, 0.0])
    assert mesh.visual.uv.min() == pytest.approx(-2.0)
    assert mesh.visual.material.baseColorTexture.size == (8, 8)


def test_mesh_without_coordinates_has_the_mean_colour(tmp_path: Path) -> None:
    texture = read_texture(str(write_halves(tmp_path / "halves.png")), tmp_path)
    mean = (105, 15, 110)
    assert texture.mean == mean
    write_ball(tmp_path / "a.stl")
    (tmp_path / "far.obj").write_text(QUAD.replace("vt 1 0", "vt 1e7 0"))
    for name in ("a.stl", "far.obj"):
        model = read_model(f"file://{tmp_path}/{name}", ONE, texture=texture)
        assert not model.has_texture, name
        # In glTF, colours are amounts of light.
        assert opened(model.glb).visual.material.main_color.tolist() == [36, 1, 40, 255], name


def test_texture_of_a_robot_is_found_as_its_meshes_are(tmp_path: Path) -> None:
    package = tmp_path / "src" / "bot"
    (package / "urdf").mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>bot</name></package>")
    path = write_halves(package / "halves.png")
    (package / "urdf" / "a.obj").write_text(QUAD)
    for name in ("package://bot/halves.png", path.as_uri(), "../halves.png", str(path)):
        display = loaded(robot(MESH_OBJ, textured(name)), package / "urdf")
        (placed,) = display.shapes(S)
        assert isinstance(placed.shape, shapes.Model)
        assert colors_by_x(placed.shape.glb) == {0.0: RED, 1.0: BLUE}, name
        assert display.status == "", name


def test_texture_counts_in_place_of_the_colour_and_takes_the_opacity_of_the_display(tmp_path: Path) -> None:
    write_halves(tmp_path / "halves.png")
    (tmp_path / "a.obj").write_text(QUAD)
    text = robot(MESH_OBJ, textured("halves.png", '<color rgba="0 1 0 0.2"/>'))
    (placed,) = loaded(text, tmp_path).shapes(S)
    assert isinstance(placed.shape, shapes.Model)
    assert colors_by_x(placed.shape.glb) == {0.0: RED, 1.0: BLUE}
    assert b"BLEND" not in placed.shape.glb
    faint = loaded(text, tmp_path)
    faint.settings["opacity"] = 0.5
    faint.clear()
    faint.take(robot_model_message(text), S)
    (placed,) = faint.shapes(S)
    assert isinstance(placed.shape, shapes.Model)
    assert b'"alphaMode": "BLEND"' in placed.shape.glb
    assert placed.shape.has_texture


def robot_model_message(text: str) -> Any:
    from tfloom.interfaces.std_msgs.msg import String

    return String(data=text)


def test_form_without_coordinates_has_the_mean_colour_which_is_said_unless_it_is_the_only_one(
    tmp_path: Path,
) -> None:
    write_ball(tmp_path / "a.stl")
    write_halves(tmp_path / "halves.png")
    write_plain(tmp_path / "plain.png")
    for form in (BOX, '<cylinder radius="1" length="1"/>', '<sphere radius="1"/>'):
        (placed,) = loaded(robot(form, textured("plain.png")), tmp_path).shapes(S)
        assert getattr(placed.shape, "color", None) == RED
    for form in (BOX, MESH_STL):
        assert loaded(robot(form, textured("plain.png")), tmp_path).status == ""
        display = loaded(robot(form, textured("halves.png")), tmp_path)
        assert display.status == "a form without texture coordinates has the mean colour of halves.png"
        assert len(display.shapes(S)) == 1


def bomb() -> bytes:
    """Return a PNG of some hundred bytes that claims 60,000 by 60,000 pixels."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", 60_000, 60_000, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(bytes(100)))


def damaged() -> bytes:
    file = io.BytesIO()
    Image.new("RGB", (64, 64), RED).save(file, "PNG")
    return file.getvalue()[:-40]


CANT = "is not a picture that can be read: "
FAULTS: dict[str, tuple[str, bytes | None, str]] = {
    "absent": ("t.png", None, "t.png can't be read: No such file or directory"),
    "of another format": ("t.tga", b"x", "t.tga is not a file of a texture: its name ends in none of .png"),
    "a text": ("t.png", b"#!/bin/sh", f"t.png {CANT}its file is neither JPEG, PNG nor WebP"),
    "empty": ("t.png", b"", f"t.png {CANT}its file is neither JPEG, PNG nor WebP"),
    "damaged": ("t.png", damaged(), f"t.png {CANT}its file is damaged"),
    "a bomb": ("t.png", bomb(), f"t.png {CANT}it has too many pixels to be opened"),
    "of no package": ("package://nowhere/t.png", None, "there is no package 'nowhere'"),
    "of the net": ("http://127.0.0.1/t.png", None, "begins neither with package:// nor with file://"),
    "of a name that no system has": (f"package://nowhere/{'x' * 5000}.png", None, f"{'x' * 20}.png"),
    "no URI": ("file://[t.png", None, "is not a URI"),
}


@pytest.mark.parametrize("kind", FAULTS)
def test_link_whose_texture_cant_be_read_has_its_colour_and_its_display_says_why(
    kind: str, tmp_path: Path
) -> None:
    name, content, fault = FAULTS[kind]
    if content is not None:
        (tmp_path / name).write_bytes(content)
    write_ball(tmp_path / "a.stl")
    for form, color, expected in (
        (MESH_STL, '<color rgba="0 1 0 1"/>', (0, 255, 0)),
        (BOX, '<color rgba="0 1 0 1"/>', (0, 255, 0)),
        (BOX, "", (180, 180, 180)),
    ):
        display = loaded(robot(form, textured(name, color), collision='<sphere radius="9"/>'), tmp_path)
        (placed,) = display.shapes(S)
        if isinstance(placed.shape, shapes.Model):
            assert tuple(opened(placed.shape.glb).visual.material.main_color.tolist()) == (*expected, 255)
        else:
            assert getattr(placed.shape, "color", None) == expected
        assert display.status.startswith("shown without a texture: ")
        assert fault in display.status
        assert "0x" not in display.status, "an address says nothing"


def test_missing_texture_of_many_links_is_one_fault(tmp_path: Path) -> None:
    form = f"<visual><geometry>{BOX}</geometry><material name='m'>{textured('t.png')}</material></visual>"
    links = "".join(f'<link name="{name}">{form}</link>' for name in "abc")
    display = loaded(f'<robot name="r">{links}</robot>', tmp_path)
    assert len(display.shapes(S)) == 3
    assert display.status == "shown without a texture: t.png can't be read: No such file or directory"


def test_too_long_a_file_and_what_is_not_a_regular_one_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_plain(tmp_path / "t.png")
    (tmp_path / "zero.png").symlink_to("/dev/zero")
    (tmp_path / "status.png").symlink_to("/proc/self/status")
    monkeypatch.setattr(textures, "MAX_TEXTURE_BYTES", 50)
    for name, fault in (
        ("t.png", "more than 50 bytes"),
        ("status.png", "more than 50 bytes"),
        ("zero.png", "not a regular file"),
    ):
        with pytest.raises(DisplayError, match=fault):
            read_texture(name, tmp_path)


def test_too_many_pixels_are_refused_before_any_is_decoded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_halves(tmp_path / "t.png", size=16)
    monkeypatch.setattr(pictures, "MAX_PIXELS", 255)
    monkeypatch.setattr(Image.Image, "convert", lambda *_: pytest.fail("it is decoded"))
    with pytest.raises(DisplayError, match="it has 16 by 16 pixels, too many to be opened"):
        read_texture("t.png", tmp_path)


def test_shade_of_a_colour_is_one_colour_and_two_colours_are_not(tmp_path: Path) -> None:
    for name, last, is_plain in (("shade", 78, True), ("contrast", 120, False)):
        levels = np.linspace(29, last, 64).astype(np.uint8)
        Image.fromarray(np.tile(levels[:, np.newaxis, np.newaxis], (1, 8, 3))).save(tmp_path / f"{name}.png")
        assert read_texture(f"{name}.png", tmp_path).is_plain == is_plain


def test_large_picture_is_reduced_and_each_mode_and_format_is_read(tmp_path: Path) -> None:
    for name, mode in (
        ("a.png", "RGBA"),
        ("b.png", "L"),
        ("c.png", "P"),
        ("d.jpg", "RGB"),
        ("e.webp", "RGB"),
    ):
        Image.new("RGB", (3 * textures.MAX_SIDE_PX, 30), RED).convert(mode).save(tmp_path / name)
        texture = read_texture(name, tmp_path)
        assert texture.picture.size == (textures.MAX_SIDE_PX, 10), name
        assert texture.picture.mode == "RGB", name
        assert texture.is_plain, name
        if mode != "L":
            assert np.abs(np.subtract(texture.mean, RED)).max() < 8, name


def test_texture_is_read_once_a_bad_one_too_and_anew_when_its_file_changes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    reads: list[bytes] = []
    read = textures.opened_picture
    monkeypatch.setattr(
        textures, "opened_picture", lambda data, side: (reads.append(data), read(data, side))[1]
    )
    path = write_plain(tmp_path / "t.png")
    (tmp_path / "a.obj").write_text(QUAD)
    first = read_texture("t.png", tmp_path)
    assert read_texture(path.as_uri(), None) is first
    before = read_model("a.obj", ONE, near=tmp_path, texture=first)
    assert read_model("a.obj", ONE, near=tmp_path, texture=first).glb is before.glb
    assert len(reads) == 1
    write_halves(path)
    os.utime(path, ns=(1, 1))
    changed = read_texture("t.png", tmp_path)
    assert changed.mean != first.mean
    assert read_model("a.obj", ONE, near=tmp_path, texture=changed).glb != before.glb
    path.write_bytes(b"bad")
    for _ in range(3):
        with pytest.raises(DisplayError, match="neither JPEG"):
            read_texture("t.png", tmp_path)
    assert len(reads) == 3
    path.unlink()
    with pytest.raises(DisplayError, match="No such file"):
        read_texture("t.png", tmp_path)


def test_kept_textures_have_a_limit(tmp_path: Path) -> None:
    for number in range(textures.MAX_KEPT + 2):
        write_plain(tmp_path / f"{number}.png")
        read_texture(f"{number}.png", tmp_path)
    kept = [key[0] for key, texture in textures._kept.items() if isinstance(texture, Texture)]
    assert [Path(name).stem for name in kept] == [str(number + 2) for number in range(textures.MAX_KEPT)]


def test_meshes_of_a_robot_have_a_limit_beyond_which_the_rest_stands_in(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A file of one mesh may be named by each of thousands of links, for which pages get it each time."""
    write_ball(tmp_path / "a.stl")
    size = len(read_model("a.stl", ONE, near=tmp_path).glb)
    monkeypatch.setattr(robot_model, "MAX_MESH_BYTES", 2 * size)
    links = "".join(link_of(name, MESH_STL, BOX) for name in "abcd")
    display = loaded(f'<robot name="r">{links}</robot>', tmp_path)
    kinds = [type(placed.shape) for placed in display.shapes(S)]
    assert kinds == [shapes.Model, shapes.Model, shapes.Box, shapes.Box]
    assert f"the meshes of the robot have more than {2 * size} bytes" in display.status
    display.take(robot_model_message(f'<robot name="r">{link_of("e", MESH_STL, BOX)}</robot>'), S)
    assert [type(placed.shape) for placed in display.shapes(S)] == [shapes.Model]
