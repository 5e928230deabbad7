"""What is shown of a robot whose meshes are absent, hostile or many."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tfloom.interfaces.std_msgs.msg import String
from tfloom.viewer import shapes
from tfloom.viewer.displays import robot_model
from tfloom.viewer.displays.robot_model import RobotDisplay
from tfloom.viewer.displays.settings import ROBOT_SETTINGS, usual_values

S = 1_000_000_000


def loaded(text: str, near: Path | None = None) -> RobotDisplay:
    """Return a display of a robot all files of which were read."""
    display = RobotDisplay(usual_values(ROBOT_SETTINGS))
    display.near = near
    display.take(String(data=text), S)
    while not display.is_whole:
        display.shapes(S)
    display.shapes(S)
    return display


def link_of(name: str, visual: str, collision: str) -> str:
    forms = (("visual", visual), ("collision", collision))
    parts = (f"<{tag}><geometry>{form}</geometry></{tag}>" for tag, form in forms if form)
    return f'<link name="{name}">{"".join(parts)}</link>'


ABSENT = '<mesh filename="meshes/absent.stl"/>'
BOX = '<box size="1 1 1"/>'


def test_form_of_the_collision_stands_in_for_a_mesh_with_the_reason(tmp_path: Path) -> None:
    links = (
        link_of("a", ABSENT, BOX)
        + link_of("b", BOX, '<sphere radius="9"/>')
        + link_of("c", ABSENT, "<cone/>")
    )
    display = loaded(f'<robot name="r">{links}</robot>', tmp_path)
    seen, stand_in = display.shapes(S)
    assert (seen.frame_id, stand_in.frame_id) == ("b", "a")
    assert stand_in.shape == shapes.Box((1.0, 1.0, 1.0), (180, 180, 180), 0.6)
    assert display.status.startswith(
        "forms of collisions stand in: meshes/absent.stl can't be read: No such file"
    )
    assert display.status.endswith("(and 1 more)")


def test_robot_of_which_nothing_is_visual_has_the_forms_of_its_collisions() -> None:
    display = loaded(f'<robot name="r">{link_of("a", "", BOX)}{link_of("b", "", "")}</robot>')
    assert [placed.frame_id for placed in display.shapes(S)] == ["a"]
    assert display.status == "forms of collisions stand in: nothing of it is visual"


def test_another_link_has_what_is_seen_where_no_mesh_can_be_read() -> None:
    links = link_of("a", ABSENT, "") + link_of("a_collision", "", BOX)
    assert [placed.frame_id for placed in loaded(f'<robot name="r">{links}</robot>').shapes(S)] == [
        "a_collision"
    ]


def test_meshes_are_read_a_few_at_a_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(robot_model, "LOAD_S", 0.0)
    display = RobotDisplay(usual_values(ROBOT_SETTINGS))
    display.take(
        String(data=f'<robot name="r">{"".join(link_of(name, BOX, "") for name in "abc")}</robot>'), S
    )
    counts = [len(display.shapes(S))]
    assert display.status == "1 of 3 forms are read"
    while not display.is_whole:
        counts.append(len(display.shapes(S)))
    assert (counts, display.status) == ([1, 2, 3], "")


def test_forms_beyond_the_limit_are_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(robot_model, "MAX_VISUALS", 3)
    links = "".join(link_of(name, ABSENT if name == "a" else BOX, BOX) for name in "abcde")
    assert len(loaded(f'<robot name="r">{links}</robot>').shapes(S)) == 2


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes with names")
def test_pipe_and_endless_file_are_a_sentence_each(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.stl")
    (tmp_path / "zero.stl").symlink_to("/dev/zero")
    for name in ("pipe.stl", "zero.stl"):
        display = loaded(
            f'<robot name="r">{link_of("a", f"""<mesh filename="{name}"/>""", BOX)}</robot>', tmp_path
        )
        assert f"{name} can't be read: it is not a regular file" in display.status
        assert len(display.shapes(S)) == 1


def test_package_is_named_that_is_nowhere() -> None:
    display = loaded(
        f'<robot name="r">{link_of("a", """<mesh filename="package://nowhere/a.stl"/>""", "")}</robot>'
    )
    assert display.status.startswith("there is no package 'nowhere', which package://nowhere/a.stl is in")
