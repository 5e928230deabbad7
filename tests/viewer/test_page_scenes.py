"""What of the scene is each page's own, by pages and scenes that are not browsers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from typing import Any
from urllib.parse import urlsplit

import pytest
from tests.conftest import wait_until
from tests.viewer.conftest import Page
from tests.viewer.messages import header
from tests.viewer.scenes import Scene

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.node import Node
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
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
    scene.abort()
    scene = open_scene(first)
    number = viewer._server._clients[first.name]
    first.wait_for(lambda: set(shown(viewer, first)) == set(SEEN))
    assert viewer._scenes._pages[first.name].client.client_id == number
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
    page.wait_for(lambda: shown(viewer, page))
    page.send(op="look", at=[0.5, 0.5])
    scene.wait_for(lambda: scene.camera.get("position", (9.0, 9.0, 9.0))[2] < 3.0)
    assert scene.camera["position"][:2] == pytest.approx((0.0, 0.0), abs=1e-6)
    assert page.ask("error", op="look", at=[0.01, 0.01]) == "there is nothing at this place"


@pytest.mark.parametrize(
    ("command", "said"),
    [
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
