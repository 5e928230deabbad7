"""`tfloom view robot.urdf`: a robot from a file, without a node; its joints, its links, and files that are none."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
import trimesh
from tests.conftest import Program, wait_until
from tests.viewer.conftest import Page, running
from tests.viewer.scenes import Scene

from tfloom.cli import view
from tfloom.cli.shared.errors import CommandError
from tfloom.viewer import described
from tfloom.viewer.described import described_viewer, read_robot

ARM = Path(__file__).parents[2] / "examples" / "robot" / "arm.urdf"
ROBOT = """<robot name="bot"><link name="base"><visual><geometry><mesh filename="package://bot/meshes/base.stl"/></geometry>
</visual></link><link name="tip"><visual><geometry><mesh filename="package://bot/meshes/absent.stl"/></geometry></visual>
<collision><geometry><box size="1 1 1"/></geometry></collision></link>
<joint name="lift" type="prismatic"><parent link="base"/><child link="tip"/><axis xyz="0 0 1"/>
<limit lower="0" upper="2" effort="1" velocity="1"/></joint></robot>"""
PageOpener = Callable[[Any], Page]


@pytest.fixture
def bot(tmp_path: Path) -> Path:
    """A package with a robot, one mesh of which is absent."""
    path = tmp_path / "bot" / "urdf" / "bot.urdf"
    path.parent.mkdir(parents=True)
    path.write_text(ROBOT)
    (tmp_path / "bot" / "meshes").mkdir()
    trimesh.creation.box((1.0, 1.0, 1.0)).export(tmp_path / "bot" / "meshes" / "base.stl")
    return path


@contextmanager
def shown(name: Path | str) -> Iterator[Any]:
    with described_viewer(read_robot(str(name))) as viewer, running(viewer):
        viewer.view.want(described.DESCRIPTION_TOPIC)
        yield viewer


def test_robot_of_a_file_is_shown_with_what_it_lacks(bot: Path, open_page: PageOpener) -> None:
    with shown(bot) as viewer:
        page = open_page(viewer)
        status = "forms of collisions stand in: package://bot/meshes/absent.stl can't be read"
        page.wait_for(lambda: (page.display("/robot_description") or {}).get("status", "").startswith(status))
        assert page.state["fixed_frame"] == "base"
        assert (page.state["is_live"], page.state["is_recording"]) == (False, False)
        assert page.state["findings"] == []
        assert [row["frame"] for row in page.state["rows"]] == ["base", "tip"]
        (joint,) = page.state["joints"]
        assert (joint["name"], joint["least"], joint["greatest"], joint["position"]) == (
            "lift",
            0.0,
            2.0,
            0.0,
        )


def test_slider_moves_the_link_and_a_selected_link_has_its_transform(
    bot: Path, open_page: PageOpener
) -> None:
    with shown(bot) as viewer:
        page = open_page(viewer)
        page.wait_for(lambda: page.row("tip"))
        page.send(op="select", frame="tip")
        said = page.wait_for(lambda: (page.state["selection"] or {}).get("text"))
        assert said.startswith("tip is on base by the prismatic joint lift\n")
        page.send(op="joint", name="lift", position=1.5)
        page.wait_for(lambda: "- Translation: [0.000, 0.000, 1.500]" in page.state["selection"]["text"])
        page.send(op="pose", to="rest")
        page.wait_for(lambda: "- Translation: [0.000, 0.000, 0.000]" in page.state["selection"]["text"])
        page.send(op="unselect")
        page.send(op="select", frame="base")
        page.wait_for(lambda: (page.state["selection"] or {}).get("text") == "It is the fixed frame.")


def test_nobody_is_asked_of_a_file(bot: Path, open_page: PageOpener) -> None:
    with shown(bot) as viewer:
        page = open_page(viewer)
        assert page.ask("error", op="graph") == "this is a file: there is nobody to ask"


def shown_whole(page: Page) -> str:
    """Wait until all of a robot is read, and return what is said of it."""

    def status() -> str:
        said = str((page.display("/robot_description") or {}).get("status", ""))
        return "" if said.endswith("are read") or said == "no message yet" else said

    return str(page.wait_for(status))


def scene_of(viewer: Any, page: Page) -> Scene:
    return Scene(urlsplit(viewer.pages.address).port or 0, page)


def test_click_on_a_shape_selects_its_link(bot: Path, open_page: PageOpener) -> None:
    with shown(bot) as viewer:
        page = open_page(viewer)
        shown_whole(page)
        drawn = viewer.view._scene._displays["/robot_description"]
        for shape, link in zip(drawn, ("base", "tip"), strict=True):
            plain, _ = shape._handle._impl.click_cb  # the other is with the shift key
            plain.callback(None)
            page.wait_for(lambda link=link: link in (page.state["selection"] or {"frames": []})["frames"])


def test_camera_sees_the_robot_whole_until_its_user_moves_it(bot: Path, open_page: PageOpener) -> None:
    with shown(bot) as viewer:
        page = open_page(viewer)
        shown_whole(page)
        page.send(op="fit_start")
        scene = scene_of(viewer, page)
        scene.tell_camera(position=(3.0, 0.0, 0.0))
        scene.wait_for(lambda: scene.camera.get("position") is not None)
        # The robot is a box of 1 m, and the camera, on its x axis, sees it from the side that it has.
        x, *others = scene.camera["position"]
        assert 1.0 < x < 3.0
        assert others == pytest.approx([0.0, 0.0], abs=1e-6)
        page.wait_for(lambda: not viewer._unfitted)
        page.send(op="joint", name="lift", position=2.0)
        page.wait_for(lambda: page.state["joints"][0]["position"] == 2.0)
        scene.camera.clear()
        page.send(op="fit")
        # A camera that is moved takes its point along, which comes back with the next message.
        middle = pytest.approx((0.0, 0.0, 1.0), abs=1e-6)
        scene.wait_for(lambda: scene.camera.get("look_at") == middle)
        scene.abort()


def test_camera_of_a_page_that_begins_anew_is_told_again_until_its_user_moves_it(
    bot: Path, open_page: PageOpener, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A browser that draws slowly places its first camera after it has taken the one that it was told."""
    with shown(bot) as viewer:
        page = open_page(viewer)
        shown_whole(page)
        page.send(op="fit_start")
        scene = scene_of(viewer, page)
        for _ in range(3):
            scene.camera.clear()
            scene.tell_camera(position=(3.0, 0.0, 0.0))
            scene.wait_for(lambda: scene.camera.get("position") is not None)
            assert 1.0 < scene.camera["position"][0] < 3.0
            page.wait_for(lambda: page.name in viewer._settling)
        scene.tell_camera(position=(0.0, 5.0, 0.0))
        page.wait_for(lambda: not viewer._settling)
        looks: list[Any] = []
        monkeypatch.setattr(viewer._server, "look", lambda *words: looks.append(words))
        scene.tell_camera(position=(3.0, 0.0, 0.0))
        wait_until(lambda: viewer._server.view_point(page.name).position[0] == 3.0, what="the camera")
        page.send(op="axes", length=0.5)
        page.wait_for(lambda: page.state["axes_m"] == 0.5)
        assert looks == []
        scene.abort()


def test_camera_is_let_go_though_a_display_waits_for_a_topic(bot: Path, open_page: PageOpener) -> None:
    with shown(bot) as viewer:
        viewer.view.want("/scan")
        page = open_page(viewer)
        page.send(op="fit_start")
        page.wait_for(lambda: page.name in viewer._unfitted)
        scene = scene_of(viewer, page)
        scene.tell_camera(position=(3.0, 0.0, 0.0))
        page.wait_for(lambda: not viewer._unfitted)
        scene.abort()


def test_picture_of_nothing_is_not_fitted(bot: Path, open_page: PageOpener) -> None:
    with shown(bot) as viewer:
        page = open_page(viewer)
        assert page.ask("error", op="fit") == "nothing is shown yet"


@pytest.mark.skipif(find_spec("xacro") is None, reason="needs the extra robot")
def test_xacro_is_expanded(bot: Path, open_page: PageOpener) -> None:
    path = bot.with_suffix(".urdf.xacro")
    path.write_text(
        ROBOT.replace("<robot ", '<robot xmlns:xacro="http://ros.org/wiki/xacro" ').replace(
            'upper="2"', 'upper="${1+2}"'
        )
    )
    with shown(path) as viewer:
        page = open_page(viewer)
        assert page.state["joints"][0]["greatest"] == 3.0


XACRO = """<robot name="bot" xmlns:xacro="http://ros.org/wiki/xacro"><xacro:arg name="reach" default="1"/>
<xacro:include filename="$(find {package})/urdf/lift.xacro"/><link name="base"/>
<xacro:lift reach="$(arg reach)"/></robot>"""
LIFT = """<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:macro name="lift" params="reach">
<link name="tip"><visual><geometry><mesh filename="file://$(find parts)/meshes/a.stl"/></geometry></visual></link>
<joint name="lift" type="prismatic"><parent link="base"/><child link="tip"/>
<limit lower="0" upper="${reach}" effort="1" velocity="1"/></joint></xacro:macro></robot>"""


@pytest.fixture
def clone(tmp_path: Path) -> Path:
    """A description in a clone of two packages that no workspace has built, the second one in another folder."""
    parts = tmp_path / "a clone" / "common" / "urdf" / "lift.xacro"
    parts.parent.mkdir(parents=True)
    parts.write_text(LIFT)
    (parts.parents[1] / "package.xml").write_text("<package><name>parts</name></package>")
    path = tmp_path / "a clone" / "bot" / "urdf" / "bot.urdf.xacro"
    path.parent.mkdir(parents=True)
    path.write_text(XACRO.format(package="parts"))
    return path


@pytest.mark.skipif(find_spec("xacro") is None, reason="needs the extra robot")
def test_xacro_finds_packages_around_it_and_takes_arguments(
    clone: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = clone.parents[2]
    assert f"file://{folder}/common/meshes/a.stl" in read_robot(str(clone)).text
    monkeypatch.chdir(folder)
    robot = read_robot("bot/urdf/bot.urdf.xacro", ["reach:=2.5"])
    assert robot.model.description.joints["lift"].limit.upper == 2.5
    # Those around the file count before an installed one of the name.
    installed = folder.parent / "installed"
    (installed / "share" / "ament_index" / "resource_index" / "packages").mkdir(parents=True)
    (installed / "share" / "ament_index" / "resource_index" / "packages" / "parts").touch()
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(installed))
    assert f"file://{folder}/common/meshes/a.stl" in read_robot(str(clone)).text
    # A file far from them needs the installed one.
    (installed / "share" / "parts" / "urdf").mkdir(parents=True)
    (installed / "share" / "parts" / "urdf" / "lift.xacro").write_text(LIFT)
    far = folder.parent / "far" / "bot.xacro"
    far.parent.mkdir()
    far.write_text(clone.read_text())
    assert f"file://{installed}/share/parts/meshes/a.stl" in read_robot(str(far)).text
    # One of another clone counts after it.
    other = folder.parent / "clones" / "other" / "parts"
    (other / "urdf").mkdir(parents=True)
    (other / "urdf" / "lift.xacro").write_text(LIFT)
    (other / "package.xml").write_text("<package><name>parts</name></package>")
    near = far.rename(other.parents[1] / "bot.xacro")
    assert f"file://{installed}/share/parts/meshes/a.stl" in read_robot(str(near)).text
    monkeypatch.delenv("AMENT_PREFIX_PATH")
    assert f"file://{other}/meshes/a.stl" in read_robot(str(near)).text


@pytest.mark.skipif(find_spec("xacro") is None, reason="needs the extra robot")
def test_xacro_in_a_file_of_urdf_is_expanded(clone: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = clone.rename(clone.with_name("bot.urdf"))
    robot = read_robot(str(path), ["reach:=3"])
    assert robot.model.description.joints["lift"].limit.upper == 3.0
    # Without the library it is shown as it is, with remarks.
    path.write_text(ROBOT.replace("<link", '<xacro:arg name="reach"/><link', 1))
    monkeypatch.setattr(described, "find_spec", lambda _: None)
    assert "xacro that was not expanded" in str(read_robot(str(path)).model.description.remarks[0])


@pytest.mark.skipif(find_spec("xacro") is None, reason="needs the extra robot")
def test_package_that_xacro_finds_nowhere_is_named(clone: Path, capfd: pytest.CaptureFixture[str]) -> None:
    clone.write_text(XACRO.format(package="nowhere"))
    hint = "; arguments of xacro follow the file, as NAME:=VALUE; it has reach"
    assert complaint(str(clone)) == f"{clone} can't be expanded: the reason is above{hint}"
    assert complaint(str(clone), "reach:=2") == f"{clone} can't be expanded: the reason is above"
    first = capfd.readouterr().err.splitlines()[0]
    assert first == f"error: there is no package 'nowhere', and none around {clone.parent}"


@pytest.mark.skipif(find_spec("xacro") is None, reason="needs the extra robot")
def test_argument_that_is_not_given_is_named(clone: Path, capfd: pytest.CaptureFixture[str]) -> None:
    clone.write_text(clone.read_text().replace('name="bot"', 'name="$(arg who)"', 1))
    complaint(str(clone))
    printed = capfd.readouterr().err.splitlines()
    assert printed[0] == "error: Undefined substitution argument who (add who:=VALUE)"


def test_arguments_that_nobody_takes_are_named(bot: Path) -> None:
    assert (
        complaint(str(bot), "reach:=2") == f"{bot} is not a file of xacro: it takes no argument, as reach:=2"
    )
    for words in ((str(bot), "reach"), ("a_bag", "reach:=2"), (str(bot), ":=2")):
        assert f"{words[1]} is too much" in complaint(*words)


def test_description_of_a_package(bot: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    prefix = bot.parents[2]
    index = prefix / "share" / "ament_index" / "resource_index" / "packages"
    index.mkdir(parents=True)
    (index / "bot").touch()
    bot.parents[1].rename(prefix / "share" / "bot")
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(prefix))
    assert read_robot("package://bot/urdf/bot.urdf").folder == prefix / "share" / "bot" / "urdf"


def complaint(*words: str) -> str:
    parser = argparse.ArgumentParser()
    view.add_arguments(parser)
    with pytest.raises(CommandError) as caught:
        view.main(parser.parse_args([*words, "--no-open", "--port", "0"]))
    return str(caught.value)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("<robot", "line 1: "),
        ("", "line 1: "),
        ('<robot name="r"><link name="a"/><link name="b"/></robot>', "root"),
        ('<sdf version="1"/>', "the outermost element is <sdf>, not <robot>"),
        ('<robot name="r">' + "<a>" * 300 + "</a>" * 300 + "</robot>", "nested"),
    ],
)
def test_broken_description_is_one_sentence(tmp_path: Path, text: str, why: str) -> None:
    path = tmp_path / "bad.urdf"
    path.write_text(text)
    said = complaint(str(path))
    assert said.startswith(f"{path}: ")
    assert why in said
    assert len(said.splitlines()) == 1


def test_what_is_no_file_is_one_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "folder.urdf").mkdir()
    (tmp_path / "zero.urdf").symlink_to("/dev/zero")
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "pipe.urdf")
    for path in sorted(tmp_path.iterdir()):
        assert "can't be read: " in complaint(str(path)), path
    assert "can't be read: No such file" in complaint(str(tmp_path / "absent.xacro"))
    assert "there is no package" in complaint("package://nowhere/a.urdf")
    monkeypatch.setattr(described, "MAX_BYTES", 100)
    long = tmp_path / "long.urdf"
    long.write_text(ROBOT)
    assert complaint(str(long)) == f"{long} has more than 100 bytes"


def test_robot_and_recording_are_not_shown_together(bot: Path) -> None:
    assert "the page shows one" in complaint(str(bot), "--bag", "there")
    assert "has no time" in complaint(str(bot), "--use-sim-time")


@pytest.mark.skipif(find_spec("xacro") is None, reason="needs the extra robot")
def test_xacro_that_cant_be_expanded_is_a_sentence(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "bad.xacro"
    path.write_text('<robot xmlns:xacro="http://ros.org/wiki/xacro" name="${nothing}"/>')
    assert (
        complaint(str(path))
        == f"{path} can't be expanded: the reason is above; arguments of xacro follow the file, as NAME:=VALUE"
    )
    printed = capfd.readouterr().err
    assert "nothing" in printed
    assert "Traceback" not in printed


@pytest.mark.skipif(sys.platform == "win32", reason="signals end programs otherwise there")
def test_command_prints_its_address_and_ends_with_ctrl_c(
    bot: Path, start_program: Callable[..., Program]
) -> None:
    program = start_program("tfloom", "view", str(bot), "--no-open", "--port", "0")
    assert program.wait_for("Open http://127.0.0.1:")
    program.signal(2)
    assert program.wait() == 0, program.output
    assert "Traceback" not in program.output
