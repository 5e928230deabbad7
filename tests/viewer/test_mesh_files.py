"""Files of meshes: units and faults; no file keeps the viewer waiting, or fills its memory."""

from __future__ import annotations

import io
import os
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from tests.conftest import wait_until

from tfloom.viewer import mesh_files
from tfloom.viewer.mesh_files import read_model
from tfloom.viewer.mesh_places import ENDINGS
from tfloom.viewer.shapes import DisplayError

ONE = (1.0, 1.0, 1.0)
COLLADA = """<?xml version="1.0" encoding="utf-8"?>{before}
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><created>2020-01-01T00:00:00</created><modified>2020-01-01T00:00:00</modified>{unit}<up_axis>{up}</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh><source id="p"><float_array id="pa" count="12">
0 0 0 1 0 0 0 2 0 0 0 3</float_array><technique_common><accessor source="#pa" count="4" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common>
</source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="4">
<input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>"""


@pytest.fixture(autouse=True)
def nothing_kept() -> Iterator[None]:
    mesh_files._kept.clear()
    yield
    mesh_files._kept.clear()


def write_ball(path: Path, radius: float = 1.0) -> None:
    trimesh.creation.icosphere(subdivisions=0, radius=radius).export(path)


def size_of(glb: bytes) -> list[float]:
    mesh: Any = trimesh.load(io.BytesIO(glb), file_type="glb", force="mesh")
    size: list[float] = np.ptp(mesh.bounds, axis=0).tolist()
    return size


def fault_of(uri: str) -> str:
    """Return why a file can't be read, and check that this is found out without waiting."""
    faults: list[str] = []

    def read() -> None:
        try:
            read_model(uri, ONE)
        except DisplayError as error:
            faults.append(str(error))

    thread = threading.Thread(target=read, daemon=True)
    thread.start()
    thread.join(20.0)
    assert not thread.is_alive(), f"{uri} is waited for"
    assert faults, f"{uri} is read"
    return faults[0]


@pytest.mark.parametrize(
    ("unit", "factor"),
    [
        ("", 1.0),
        ('<unit name="meter" meter="1"/>', 1.0),
        ('<unit name="inch" meter="0.0254"/>', 0.0254),
        ('<unit meter="1e-3"/>', 0.001),
        ('<unit name="foot"/>', 1.0),
        ('<unit meter="two"/>', 1.0),
        ('<unit meter="nan"/>', 1.0),
        ('<unit meter="-1"/>', 1.0),
        ('<unit meter="1e300"/>', 1.0),
        ('<contributor><unit meter="7"/></contributor><unit meter="2"/>', 2.0),
    ],
)
@pytest.mark.parametrize("up", ["Z_UP", "Y_UP", "X_UP"])
def test_collada_is_multiplied_by_its_unit_and_not_turned_by_its_up_axis(
    tmp_path: Path, unit: str, factor: float, up: str
) -> None:
    (tmp_path / "a.dae").write_text(COLLADA.format(before="", unit=unit, up=up))
    model = read_model(f"file://{tmp_path}/a.dae", (2.0, 2.0, 2.0))
    assert model.scale == (2.0, 2.0, 2.0)
    assert size_of(model.glb) == pytest.approx([factor, 2.0 * factor, 3.0 * factor])


def test_mesh_has_the_colour_that_is_given(tmp_path: Path) -> None:
    for name in ("a.stl", "a.glb"):
        write_ball(tmp_path / name)
        for color, light in {(255, 0, 0): (255, 0, 0), (0, 64, 128): (0, 13, 55)}.items():
            glb = read_model(f"file://{tmp_path}/{name}", ONE, color).glb
            mesh: Any = trimesh.load(io.BytesIO(glb), file_type="glb", force="mesh")
            assert mesh.visual.material.main_color.tolist() == [*light, 255]


def test_each_format_is_read_with_what_the_extra_installs(tmp_path: Path) -> None:
    """trimesh uses these where they are installed, and the extra `view` doesn't bring them."""
    (tmp_path / "ball.dae").write_text(COLLADA.format(before="", unit="", up="Z_UP"))
    for ending in ("stl", "obj", "ply", "glb"):
        write_ball(tmp_path / f"ball.{ending}")
    code = f"""
import sys
sys.modules.update(dict.fromkeys(("scipy", "networkx", "shapely", "lxml", "matplotlib")))  # each import fails
from tfloom.viewer.mesh_files import read_model
from tfloom.viewer.mesh_places import ENDINGS
for ending in ENDINGS:
    for color in (None, (255, 0, 0)):
        print(ending, len(read_model("file://{tmp_path}/ball" + ending, {ONE}, color).glb) > 500)
"""
    run = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, check=False, text=True, timeout=60
    )
    assert run.stdout.split() == [
        word for ending in ENDINGS for _ in range(2) for word in (ending, "True")
    ], run.stderr


def test_collada_with_entities_is_refused(tmp_path: Path) -> None:
    bomb = '<!DOCTYPE a [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;">]>'
    (tmp_path / "a.dae").write_text(COLLADA.format(before=bomb, unit="", up="Z_UP"))
    assert "entities are not supported" in fault_of(f"file://{tmp_path}/a.dae")


def test_what_is_not_a_regular_file_is_refused_at_once(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.stl")
    (tmp_path / "zero.stl").symlink_to("/dev/zero")
    (tmp_path / "random.obj").symlink_to("/dev/urandom")
    (tmp_path / "folder.glb").mkdir()
    (tmp_path / "loop.ply").symlink_to(tmp_path / "loop.ply")
    with socket.socket(socket.AF_UNIX) as bound:
        bound.bind(str(tmp_path / "a.dae"))
        faults = {
            name: fault_of(f"file://{tmp_path}/{name}")
            for name in ("pipe.stl", "zero.stl", "random.obj", "folder.glb", "loop.ply", "a.dae", "none.stl")
        }
    for name in ("pipe.stl", "zero.stl", "random.obj"):
        assert "is not a regular file" in faults[name]
    for name in ("folder.glb", "loop.ply", "a.dae", "none.stl"):
        assert "can't be read" in faults[name]


def test_pipe_with_a_writer_is_refused_too(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.stl")
    opened: list[int] = []
    thread = threading.Thread(target=lambda: opened.append(os.open(tmp_path / "pipe.stl", os.O_WRONLY)))
    thread.start()
    reader = os.open(tmp_path / "pipe.stl", os.O_RDONLY | os.O_NONBLOCK)
    try:
        wait_until(lambda: opened, what="the writer")
        assert "is not a regular file" in fault_of(f"file://{tmp_path}/pipe.stl")
    finally:
        os.close(reader)
        thread.join()
        os.close(opened[0])


@pytest.mark.parametrize(
    "uri",
    [
        "file://[x.stl",
        "package://[::1/a.stl",
        "file:///a%00b.stl",
        "file:///\0.stl",
        "file:///\ud800.stl",
        "http://127.0.0.1/a.stl",
        "a.stl",
        "",
        "package://no_such_package/a.stl",
        "package://../a.stl",
        "file:///etc/passwd",
        f"file:///{'x' * 100_000}.stl",
    ],
)
def test_uri_that_names_no_mesh_is_a_sentence(uri: str) -> None:
    assert fault_of(uri)


def test_too_long_a_file_is_refused_also_one_that_tells_no_size(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_ball(tmp_path / "a.stl")
    (tmp_path / "status.stl").symlink_to("/proc/self/status")
    monkeypatch.setattr(mesh_files, "MAX_FILE_BYTES", 100)
    assert "more than 100 bytes" in fault_of(f"file://{tmp_path}/a.stl")
    assert "more than 100 bytes" in fault_of(f"file://{tmp_path}/status.stl")


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.glb", b"glTF"),
        ("a.glb", b"glTF\2\0\0\0\xff\0\0\0"),
        ("a.stl", b""),
        ("a.stl", b"solid\nendsolid"),
        ("a.stl", bytes(80) + b"\xff\xff\xff\xff"),
        ("a.ply", b"ply\nformat ascii 1.0\nelement vertex 1000000000000\nproperty float x\nend_header\n1"),
        ("a.obj", b"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("a.obj", b"f 1 2 3\n"),
        ("a.dae", b"<COLLADA"),
        ("a.dae", b"<COLLADA/>"),
        ("a.dae", b"\xff\xfe\0"),
    ],
)
def test_content_that_is_no_mesh_is_a_sentence(tmp_path: Path, name: str, content: bytes) -> None:
    (tmp_path / name).write_bytes(content)
    assert name in fault_of(f"file://{tmp_path}/{name}")


def test_changed_file_is_read_anew_and_a_bad_one_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, uri = tmp_path / "a.stl", f"file://{tmp_path}/a.stl"
    reads: list[Any] = []
    load = trimesh.load
    monkeypatch.setattr(
        trimesh, "load", lambda *args, **options: (reads.append(args), load(*args, **options))[1]
    )
    path.write_bytes(b"bad")
    for _ in range(3):
        assert "a.stl is not a mesh" in fault_of(uri)
    assert len(reads) == 1
    write_ball(path)
    first = read_model(uri, ONE).glb
    assert read_model(uri, ONE).glb is first
    assert len(reads) == 2
    write_ball(path, 2.0)
    os.utime(path, ns=(1, 1))
    assert size_of(read_model(uri, ONE).glb)[0] == pytest.approx(2.0 * size_of(first)[0])


def test_kept_meshes_have_a_limit_and_the_last_one_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    uris = []
    for number in range(5):
        write_ball(tmp_path / f"{number}.stl")
        uris.append(f"file://{tmp_path}/{number}.stl")
    size = len(read_model(uris[0], ONE).glb)
    monkeypatch.setattr(mesh_files, "MAX_KEPT_BYTES", 2 * size)
    for uri in uris:
        read_model(uri, ONE)
    assert [Path(key[0]).stem for key in mesh_files._kept] == ["3", "4"]
    monkeypatch.setattr(mesh_files, "MAX_KEPT_BYTES", 1)
    read_model(uris[3], ONE)
    assert [Path(key[0]).stem for key in mesh_files._kept] == ["3"]
