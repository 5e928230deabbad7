"""What of the scene is each page's own, by pages and scenes that are not browsers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from typing import Any
from urllib.parse import urlsplit

import numpy as np
import pytest
from tests.conftest import wait_until
from tests.viewer.conftest import Page
from tests.viewer.messages import header
from tests.viewer.scenes import Scene

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.node import Node
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.viewer.camera import Camera, projected
from tfloom.viewer.layout.layout import Layout
from tfloom.viewer.program import Viewer

ABOVE = {"position": (0.0, 0.0, 10.0), "wxyz": (0.0, 1.0, 0.0, 0.0), "look_at": (0.0, 0.0, 0.0)}
"""A camera that looks down, with x to the right."""
SEEN = ("map", "near", "far")


@pytest.fixture
def broadcaster(node: Node) -> StaticTransformBroadcaster:
    made = StaticTransformBroadcaster(node)
    made.sendTransform([transform("near", 1.0, 1.0), transform("far", -3.0, -2.0)])
    return made


def transform(child: str, x: float, y: float) -> TransformStamped:
    message = TransformStamped(header=header("map", 1), child_frame_id=child)
    message.transform.translation.x, message.transform.translation.y = x, y
    message.transform.rotation.w = 1.0
    return message


@pytest.fixture
def open_scene(viewer: Viewer) -> Iterator[Callable[..., Scene]]:
    """Open scenes of pages, each with a camera that looks down."""
    with ExitStack() as stack:

        def open_one(page: Page, **camera: Any) -> Scene:
            scene = Scene(urlsplit(viewer.pages.address).port or 0, page)
            stack.callback(scene.abort)
            scene.tell_camera(**{**ABOVE, **camera})
            wait_until(lambda: viewer._server.camera(page.name), what="the camera")
            return scene

        yield open_one


def shown(viewer: Viewer, page: Page) -> dict[str, str]:
    """Return the texts of the names that a page shows, by frame."""
    own = viewer._scenes._pages.get(page.name)
    return {} if own is None else {name: label[0].text for name, label in list(own.labels.items())}


def test_each_page_has_its_own_names_and_a_scene_that_comes_anew_has_them_again(
    viewer: Viewer, open_page: Callable[[Viewer], Page], open_scene: Callable[..., Scene], broadcaster: Any
) -> None:
    first, second = open_page(viewer), open_page(viewer)
    scene = open_scene(first)
    open_scene(second, position=(1.0, 1.0, 0.5), look_at=(1.0, 1.0, 0.0))
    first.wait_for(lambda: set(shown(viewer, first)) == set(SEEN))
    second.wait_for(lambda: set(shown(viewer, second)) == {"near"})
    before = viewer._scenes._pages[first.name].client
    scene.abort()
    open_scene(first)
    first.wait_for(lambda: viewer._scenes._pages[first.name].client is not before)
    first.wait_for(lambda: set(shown(viewer, first)) == set(SEEN))
    first.send(op="names", on=False)
    first.wait_for(lambda: not shown(viewer, first) and not shown(viewer, second))
    first.send(op="names", on=True)
    first.wait_for(lambda: set(shown(viewer, first)) == set(SEEN) and set(shown(viewer, second)) == {"near"})
    second.socket.close()
    wait_until(lambda: second.name not in viewer._scenes._pages, what="the end of the page")
    first.wait_for(lambda: set(shown(viewer, first)) == set(SEEN))


def test_frame_that_is_hidden_has_no_name_and_has_it_again(
    viewer: Viewer, page: Page, open_scene: Callable[..., Scene], broadcaster: Any
) -> None:
    open_scene(page)
    for _ in range(2):
        page.send(op="set_frames", setting="hidden_frames", value=[])
        page.wait_for(lambda: set(shown(viewer, page)) == set(SEEN))
        page.send(op="set_frames", setting="hidden_frames", value=["near"])
        page.wait_for(lambda: set(shown(viewer, page)) == {"map", "far"})


def test_double_click_sees_a_frame_from_the_side_from_which_the_page_looks(
    viewer: Viewer, page: Page, open_scene: Callable[..., Scene], broadcaster: Any
) -> None:
    assert page.ask("error", op="look", at=[0.5, 0.5]) == "the scene has not told its camera yet"
    scene = open_scene(page)
    page.wait_for(lambda: viewer.view.poses.index_of("near") >= 0)
    page.send(op="look", at=[0.5, 0.5])
    scene.wait_for(lambda: scene.camera.get("position", (9.0, 9.0, 9.0))[2] < 3.0)
    assert scene.camera["position"][:2] == pytest.approx((0.0, 0.0), abs=1e-6)
    assert page.ask("error", op="look", at=[0.01, 0.01]) == "there is nothing at this place"


def own_camera(page: Page) -> dict[str, Any]:
    """Return what the page was told last of its camera."""
    told = [answer["own_camera"] for answer in page.answers if "own_camera" in answer]
    return told[-1] if told else {}


def position(viewer: Viewer, page: Page) -> list[float]:
    view_point = viewer._server.view_point(page.name)
    return [] if view_point is None else [round(part, 4) + 0.0 for part in view_point.position]


def test_camera_follows_a_frame_until_that_is_gone_and_again_when_it_is_there(
    viewer: Viewer, page: Page, open_scene: Callable[..., Scene], broadcaster: Any
) -> None:
    open_scene(page, position=(1.0, -3.0, 2.0), look_at=(1.0, 1.0, 0.0))
    page.wait_for(lambda: viewer.view.poses.index_of("near") >= 0)
    page.send(op="camera", kind="orbit", frame="near", turns=False)
    page.wait_for(
        lambda: own_camera(page) == {"kind": "orbit", "frame": "near", "turns": False, "is_gone": False}
    )
    broadcaster.sendTransform([transform("near", 2.0, 1.0)])
    page.wait_for(lambda: position(viewer, page) == [2.0, -3.0, 2.0])
    page.send(op="fixed_frame", frame="nowhere")
    page.wait_for(lambda: own_camera(page)["is_gone"])
    assert position(viewer, page) == [2.0, -3.0, 2.0]
    page.send(op="fixed_frame", frame="map")
    page.wait_for(lambda: not own_camera(page)["is_gone"])
    broadcaster.sendTransform([transform("near", 3.0, 1.0)])
    page.wait_for(lambda: position(viewer, page) == [3.0, -3.0, 2.0])
    page.send(op="camera", kind="orbit", frame="", turns=False)
    page.wait_for(lambda: own_camera(page)["frame"] == "")
    broadcaster.sendTransform([transform("near", 9.0, 1.0)])
    page.wait_for(lambda: viewer.view.poses.positions[viewer.view.poses.index_of("near")][0] == 9.0)
    assert position(viewer, page) == [3.0, -3.0, 2.0]


def test_camera_is_its_users_while_it_is_held(
    viewer: Viewer, page: Page, open_scene: Callable[..., Scene], broadcaster: Any
) -> None:
    scene = open_scene(page, position=(1.0, -3.0, 2.0), look_at=(1.0, 1.0, 0.0))
    page.wait_for(lambda: viewer.view.poses.index_of("near") >= 0)
    page.send(op="camera", kind="orbit", frame="near", turns=False)
    page.wait_for(lambda: own_camera(page))
    for x in (0.0, 5.0):
        page.send(op="held", on=True)
        page.wait_for(lambda: viewer._scenes._pages[page.name].is_held)
        scene.tell_camera(position=(x, 6.0, 2.0), look_at=(1.0, 1.0, 0.0), wxyz=ABOVE["wxyz"])
        page.wait_for(lambda at=x: position(viewer, page) == [at, 6.0, 2.0])
        page.send(op="held", on=False)
        page.wait_for(lambda: not viewer._scenes._pages[page.name].is_held)
        assert position(viewer, page) == [x, 6.0, 2.0]
    broadcaster.sendTransform([transform("near", 2.0, 1.0)])
    page.wait_for(lambda: position(viewer, page) == [6.0, 6.0, 2.0])


def test_page_that_closes_while_its_camera_is_held_leaves_nothing(
    viewer: Viewer, open_page: Callable[[Viewer], Page], open_scene: Callable[..., Scene], broadcaster: Any
) -> None:
    page, other = open_page(viewer), open_page(viewer)
    open_scene(page)
    page.wait_for(lambda: viewer.view.poses.index_of("near") >= 0)
    page.send(op="camera", kind="first_person", frame="near", turns=False)
    page.send(op="held", on=True)
    page.wait_for(lambda: viewer._scenes._pages[page.name].is_held)
    page.socket.close()
    wait_until(lambda: page.name not in viewer._scenes._pages, what="the end of the page")
    open_scene(other)
    other.wait_for(lambda: set(shown(viewer, other)) == set(SEEN))


def test_saved_view_is_shown_on_any_page_and_forgotten_and_saved_again(
    viewer: Viewer, open_page: Callable[[Viewer], Page], open_scene: Callable[..., Scene], broadcaster: Any
) -> None:
    first, second = open_page(viewer), open_page(viewer)
    open_scene(first, position=(1.0, -3.0, 2.0), look_at=(1.0, 1.0, 0.0))
    open_scene(second)
    first.wait_for(lambda: viewer.view.poses.index_of("near") >= 0)
    first.send(op="camera", kind="orbit", frame="near", turns=False)
    first.wait_for(lambda: own_camera(first))
    for _ in range(2):
        first.send(op="save_view", name=" door ")
        second.wait_for(lambda: second.state["views"] == ["door"])
        assert viewer.view.views["door"].frame == "near"
        second.send(op="show_view", name="door")
        second.wait_for(lambda: own_camera(second).get("frame") == "near")
        second.wait_for(lambda: position(viewer, second) == [1.0, -3.0, 2.0])
        second.send(op="camera", kind="orbit", frame="", turns=False)
        second.wait_for(lambda: own_camera(second)["frame"] == "")
        second.send(op="forget_view", name="door")
        second.wait_for(lambda: second.state["views"] == [])
        assert second.ask("error", op="show_view", name="door") == "there is no view of this name"
        assert second.ask("error", op="forget_view", name="door") == "there is no view of this name"
    for number in range(100):
        first.send(op="save_view", name=f"view {number}")
    assert first.ask("error", op="save_view", name="one more") == "there are 100 views already"
    first.send(op="save_view", name="view 3")
    first.wait_for(lambda: len(first.state["views"]) == 100)


def test_layout_has_the_camera_and_the_views_and_new_pages_look_so(
    viewer: Viewer, open_page: Callable[[Viewer], Page], open_scene: Callable[..., Scene], broadcaster: Any
) -> None:
    first = open_page(viewer)
    open_scene(first, position=(1.0, -3.0, 2.0), look_at=(1.0, 1.0, 0.0))
    first.wait_for(lambda: viewer.view.poses.index_of("near") >= 0)
    first.send(op="camera", kind="top", frame="near", turns=False)
    first.wait_for(lambda: own_camera(first))
    first.send(op="save_view", name="plan")
    text = first.ask("layout", op="layout")
    assert "kind: top" in text
    assert first.ask("layout", op="layout", form="rviz").count("TopDownOrtho") == 2
    layout = Layout(
        camera=viewer.view.views["plan"].camera,
        camera_kind="top",
        camera_frame="near",
        views=(viewer.view.views.pop("plan"),),
    )
    viewer.apply(layout)
    second = open_page(viewer)
    scene = open_scene(second)
    second.wait_for(lambda: own_camera(second).get("kind") == "top")
    scene.wait_for(lambda: scene.camera.get("position", (0.0, 0.0, 0.0))[2] > 40.0)
    second.wait_for(lambda: second.state["views"] == ["plan"])


def at(camera: Camera, x: float, y: float, z: float = 0.0) -> list[float]:
    """Return where a camera sees a place."""
    found: list[float] = projected(camera, np.array([(x, y, z)]))[0, :2].tolist()
    return found


def test_two_clicks_measure_a_third_clears_and_two_more_measure_again(
    viewer: Viewer, page: Page, open_scene: Callable[..., Scene], broadcaster: Any
) -> None:
    open_scene(page)
    page.wait_for(lambda: viewer.view.poses.index_of("near") >= 0)
    camera = viewer._server.camera(page.name)
    assert camera is not None
    client = viewer._server.client(page.name)
    assert client is not None
    for _ in range(2):
        said = page.ask("done", op="measure", at=at(camera, 1.0, 1.0))
        assert said == "from near: click on where to measure to"
        said = page.ask("done", op="measure", at=at(camera, -3.0, -2.0))
        assert said == "5.000 m from near to far: dx -4.000, dy -3.000, dz 0.000 m in map"
        (told,) = [answer["measured"] for answer in page.answers]
        assert told == {"places": [[1.0, 1.0, 0.0], [-3.0, -2.0, 0.0]], "distance_m": 5.0}
        assert client.scene.get_handle_by_name("/measure/line") is not None
        page.ask("measured", op="measure", at=at(camera, 1.0, 1.0))
        assert page.answers[0]["measured"]["places"] == []
        assert client.scene.get_handle_by_name("/measure/line") is None
    page.ask("done", op="measure", at=at(camera, 1.0, 1.0))
    assert page.ask("done", op="end_measure") == ""
    page.wait_for(lambda: viewer._scenes._pages[page.name].measure is None)
    assert client.scene.get_handle_by_name("/measure/ends") is None
    said = page.ask("done", op="measure", at=at(camera, 2.0, 3.0))
    assert said == "from the floor: click on where to measure to"
    page.answers.clear()
    page.send(op="fixed_frame", frame="near")
    assert page.answer("done") == "the fixed frame is another one: nothing is measured"
    assert viewer._scenes._pages[page.name].measure is None


def test_page_whose_scene_is_loaded_anew_or_that_closes_while_it_measures(
    viewer: Viewer, open_page: Callable[[Viewer], Page], open_scene: Callable[..., Scene], broadcaster: Any
) -> None:
    page, other = open_page(viewer), open_page(viewer)
    scene = open_scene(page)
    page.wait_for(lambda: viewer.view.poses.index_of("near") >= 0)
    camera = viewer._server.camera(page.name)
    assert camera is not None
    page.ask("done", op="measure", at=at(camera, 1.0, 1.0))
    scene.abort()
    open_scene(page)
    page.wait_for(lambda: viewer._scenes._pages[page.name].measure is None)
    assert page.ask("done", op="measure", at=at(camera, 1.0, 1.0)).startswith("from near")
    page.socket.close()
    wait_until(lambda: page.name not in viewer._scenes._pages, what="the end of the page")
    open_scene(other)
    assert other.ask("done", op="measure", at=at(camera, -3.0, -2.0)).startswith("from far")


def test_focus_turns_the_camera_to_what_is_clicked_and_leaves_it_where_it_is(
    viewer: Viewer, page: Page, open_scene: Callable[..., Scene], broadcaster: Any
) -> None:
    open_scene(page)
    page.wait_for(lambda: viewer.view.poses.index_of("near") >= 0)
    camera = viewer._server.camera(page.name)
    assert camera is not None
    assert page.ask("done", op="focus", at=at(camera, 1.0, 1.0)) == "the camera turns about near"
    view_point = viewer._server.view_point(page.name)
    assert view_point is not None
    assert (*view_point.position, *view_point.look_at) == pytest.approx((0.0, 0.0, 10.0, 1.0, 1.0, 0.0))


def test_nothing_is_measured_in_the_sky(
    viewer: Viewer, page: Page, open_scene: Callable[..., Scene], broadcaster: Any
) -> None:
    open_scene(page, wxyz=(1.0, 0.0, 0.0, 0.0), look_at=(0.0, 0.0, 20.0))  # it looks up
    for operation in ("measure", "focus"):
        assert page.ask("error", op=operation, at=[0.5, 0.5]) == "there is nothing at this place"


@pytest.mark.parametrize(
    ("command", "said"),
    [
        ({"op": "measure", "at": [0.5, 0.5]}, "the scene has not told its camera yet"),
        ({"op": "focus", "at": [0.5]}, "at has to be two numbers"),
        (
            {"op": "camera", "kind": "fish", "frame": "", "turns": False},
            "the kind of a camera is one of orbit, top, first_person",
        ),
        (
            {"op": "camera", "kind": "first_person", "frame": "", "turns": False},
            "select the frame out of which the camera is to look",
        ),
        ({"op": "camera", "kind": "orbit", "frame": "none", "turns": False}, "there is no frame 'none'"),
        ({"op": "camera", "kind": "orbit", "frame": ""}, "turns has to be true or false"),
        (
            {"op": "camera", "kind": "orbit", "frame": "", "turns": False},
            "the scene has not told its camera yet",
        ),
        ({"op": "held", "on": 1}, "on has to be true or false"),
        ({"op": "save_view", "name": "a"}, "the scene has not told its camera yet"),
        ({"op": "save_view", "name": "  "}, "the name of a view has from 1 to 64 characters"),
        ({"op": "show_view", "name": "a"}, "there is no view of this name"),
        ({"op": "look"}, "at has to be two numbers"),
        ({"op": "look", "at": [1.0]}, "at has to be two numbers"),
        ({"op": "look", "at": ["a", 1.0]}, "at has to be a finite number"),
        ({"op": "pointer", "at": 3, "width": 10, "height": 10}, "at has to be two numbers"),
        ({"op": "pointer", "at": None, "width": 10}, "height has to be a finite number"),
        (
            {"op": "pointer", "at": None, "width": 0, "height": 10},
            "a picture is from 1 to 100000 pixels wide and high",
        ),
    ],
)
def test_what_a_page_must_not_say(page: Page, command: dict[str, Any], said: str) -> None:
    assert page.ask("error", **command) == said


def test_page_whose_names_cant_be_shown_takes_none_from_others(
    viewer: Viewer,
    open_page: Callable[[Viewer], Page],
    open_scene: Callable[..., Scene],
    broadcaster: Any,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    first, second = open_page(viewer), open_page(viewer)
    camera = viewer._server.camera

    def fail_for_first(page: str) -> Any:
        if page == first.name:
            raise OSError("planted")
        return camera(page)

    open_scene(first)
    monkeypatch.setattr(viewer._server, "camera", fail_for_first)
    open_scene(second)
    second.wait_for(lambda: set(shown(viewer, second)) == set(SEEN))
    first.wait_for(
        lambda: any("names of frames can't be shown: OSError: planted" in line["text"] for line in first.log)
    )
