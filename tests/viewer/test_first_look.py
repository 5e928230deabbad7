"""What a new page sees first: all that comes, or what is missing where nothing comes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any
from urllib.parse import urlsplit

import pytest
from tests.conftest import wait_until
from tests.viewer.conftest import Page
from tests.viewer.messages import header
from tests.viewer.scenes import Scene

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.node.node import Node
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.viewer import program
from tfloom.viewer.layout.layout import ViewPoint
from tfloom.viewer.program import Viewer

OpenPage = Callable[[Viewer], Page]


def transform(child: str, x: float) -> TransformStamped:
    message = TransformStamped(header=header("map", 1), child_frame_id=child)
    message.transform.translation.x = x
    message.transform.rotation.w = 1.0
    return message


def scene_of(viewer: Viewer, page: Page) -> Scene:
    return Scene(urlsplit(viewer.pages.address).port or 0, page)


def looks_at(scene: Scene) -> Any:
    return scene.camera.get("look_at", (0.0, 0.0, 0.0))


def test_empty_scene_says_what_is_missing_until_there_is_something(
    node: Node, viewer: Viewer, page: Page, domain_id: int
) -> None:
    where = f"This page listens on domain {domain_id}. `tfloom doctor` checks what a node can hear."
    assert page.state["empty"] == f"No frames yet: nothing publishes /tf or /tf_static.\n{where}"
    publisher = node.create_publisher(TFMessage, "/tf", 10)
    said = f"No frames yet: there are publishers, 1 of /tf, of which nothing has come.\n{where}"
    page.wait_for(lambda: page.state["empty"] == said)
    wait_until(publisher.get_subscription_count, what="the viewer")
    publisher.publish(TFMessage(transforms=[transform("base", 1.0)]))
    page.wait_for(lambda: page.state["empty"] == "")


def test_scene_with_a_turtle_alone_is_not_empty(node: Node, viewer: Viewer, page: Page) -> None:
    turtle = node.create_publisher(Pose, "/turtle1/pose", 1)
    page.show("/turtle1/pose", turtle)
    assert page.state["empty"]
    turtle.publish(Pose(x=1.0, y=2.0))
    page.wait_for(lambda: page.state["empty"] == "")
    page.send(op="display", topic="/turtle1/pose", on=False)
    page.wait_for(lambda: page.state["empty"])


def test_new_page_sees_all_that_comes_until_its_user_moves_the_camera(
    node: Node, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(program, "FIT_S", 1e6)
    page.send(op="fit_start")
    scene = scene_of(viewer, page)
    scene.tell_camera()
    broadcaster = StaticTransformBroadcaster(node)
    for number, x in enumerate((10.0, 100.0)):
        broadcaster.sendTransform(transform(f"frame{number}", x))
        scene.wait_for(lambda at=x: looks_at(scene)[0] == pytest.approx(at / 2.0))
    assert viewer._unfitted
    scene.tell_camera(position=(0.0, 0.0, 9.0))
    page.wait_for(lambda: not viewer._unfitted)
    scene.camera.clear()
    broadcaster.sendTransform(transform("frame2", 1000.0))
    page.wait_for(lambda: page.row("frame2"))
    page.send(op="fit")  # which comes behind what would have come by itself
    scene.wait_for(lambda: looks_at(scene)[0] == pytest.approx(500.0))
    scene.abort()


def test_page_is_fitted_for_a_short_time(
    node: Node, viewer: Viewer, open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(program, "FIT_S", 0.0)
    looks: list[float] = []
    look = viewer._server.look

    def note(page: str, view_point: ViewPoint) -> bool:
        is_told = look(page, view_point)
        looks.extend([view_point.look_at[0]] if is_told else [])
        return is_told

    monkeypatch.setattr(viewer._server, "look", note)
    broadcaster = StaticTransformBroadcaster(node)

    def fit(page: Page) -> Scene:
        scene = scene_of(viewer, page)
        scene.tell_camera()
        wait_until(lambda: viewer._server.camera(page.name), what="the camera")
        page.send(op="fit_start")
        page.wait_for(lambda: page.name in viewer._unfitted or looks)
        return scene

    page = open_page(viewer)
    scene = fit(page)
    broadcaster.sendTransform(transform("frame0", 10.0))
    page.wait_for(lambda: looks and not viewer._unfitted)
    assert looks == [pytest.approx(5.0)]
    broadcaster.sendTransform(transform("frame1", 100.0))
    page.wait_for(lambda: page.row("frame1"))
    assert len(looks) == 1
    other = fit(open_page(viewer))
    page.wait_for(lambda: len(looks) == 2 and not viewer._unfitted)
    assert looks[1] == pytest.approx(50.0)
    for one in (scene, other):
        one.abort()


def test_page_that_closes_before_there_is_anything_leaves_nothing(viewer: Viewer, page: Page) -> None:
    page.send(op="fit_start")
    page.wait_for(lambda: page.name in viewer._unfitted)
    page.socket.close()
    wait_until(lambda: not viewer._unfitted, what="the end of the page")
