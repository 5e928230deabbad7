"""A viewer and its pages, on a live graph: what they show, what they may ask for, and what they cost."""

from __future__ import annotations

import argparse
import itertools
import math
import signal
import socket
import sys
import urllib.error
import urllib.request
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import msgspec
import numpy as np
import psutil
import pytest
from tests.conftest import Program, python_with, wait_until
from tests.viewer.conftest import Page
from tests.viewer.messages import cloud, header, marker, pose, wrench
from tests.viewer.scenes import Scene, take_all
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from tfloom.interfaces.geometry_msgs.msg import PoseStamped, TransformStamped, Twist, WrenchStamped
from tfloom.interfaces.sensor_msgs.msg import CameraInfo, Image, PointCloud2
from tfloom.interfaces.std_msgs.msg import Int64
from tfloom.interfaces.visualization_msgs.msg import Marker
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.qos.qos import QoSProfile, ReliabilityPolicy
from tfloom.rmw.errors import WireError
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.tf2_tools.text import transform_text
from tfloom.viewer import page_server, program
from tfloom.viewer.layout.layout import DisplayLayout, Layout, PlotLayout, ViewPoint
from tfloom.viewer.layout.layout_file import read_layout
from tfloom.viewer.log_lines import MAX_LINES
from tfloom.viewer.program import Viewer
from tfloom.viewer.tools import Tools

OpenPage = Callable[[Viewer], Page]
EVIL = "<img src=x onerror=alert(1)>"


def transform(parent: str, child: str, sec: int, x: float = 0.0) -> TransformStamped:
    message = TransformStamped(header=header(parent, sec), child_frame_id=child)
    message.transform.translation.x = x
    message.transform.rotation.w = 1.0
    return message


def feed(node: Node, viewer: Viewer, evil: str = EVIL) -> None:
    """Publish map → base, which moves by 1 m/s for 10 s, and two static children of base."""
    moving, static = TransformBroadcaster(node), StaticTransformBroadcaster(node)
    static.sendTransform([transform("base", "laser", 1, 0.5), transform("base", evil, 1)])
    wait_until(lambda: viewer.view.buffer.has_frame("laser"), what="static transforms")
    wait_until(moving.pub_tf.get_subscription_count, what="a subscription")
    for sec in range(101, 112):
        moving.sendTransform(transform("map", "base", sec, sec - 101.0))
    wait_until(lambda: viewer.view.buffer.can("map", "base", 111 * 10**9), what="moving transforms")


def shown(viewer: Viewer, name: str) -> Any:
    """Return a node of the scene; None where there is none of this name."""
    return viewer._server.scene.get_handle_by_name(name)


def axes_of(viewer: Viewer) -> Any:
    handle = shown(viewer, "/frames/axes")
    return None if handle is None else np.sort(handle.batched_positions[:, 0]).tolist()


def test_page_shows_frames_their_publisher_and_the_transform_as_tf2_echo_says_it(
    node: Node, viewer: Viewer, page: Page
) -> None:
    feed(node, viewer)
    page.wait_for(lambda: page.row("base") and page.row("laser") and page.row(EVIL))
    assert page.row("base")["publisher"] == "/feeder"
    assert page.row("base")["parent"] == "map"
    assert page.row("laser")["health"] == "static"
    assert page.state["fixed_frame"] == "map"
    assert page.state["span"] == [str(101 * 10**9), str(111 * 10**9)]
    page.send(op="select", frame="map")
    page.send(op="select", frame="laser")
    selection = page.wait_for(lambda: (page.state["selection"] or {}).get("text") and page.state["selection"])
    expected = viewer.view.buffer.lookup("map", "laser")
    assert expected.translation[0] == 10.5
    assert selection["text"] == transform_text(
        expected.stamp_ns, expected.translation, expected.rotation_xyzw
    )
    assert selection["plot"]["x"] == pytest.approx([x + 0.5 for x in range(11)])


def test_a_click_on_a_finding_marks_its_frames_as_long_as_it_is_there(
    node: Node, viewer: Viewer, page: Page
) -> None:
    def boxes() -> Any:
        handle = shown(viewer, "/marks")
        return None if handle is None else handle.points.reshape(-1, 24, 3).mean(axis=1).round(3).tolist()

    others = [Node(name, context=node.context) for name in ("first", "second")]
    try:
        broadcasters = [TransformBroadcaster(other) for other in others]
        stamped = TransformStamped(child_frame_id="base")
        stamped.header.frame_id = "map"
        stamped.transform.translation.x = 2.0

        def send() -> bool:
            for broadcaster in broadcasters:  # two nodes that publish one edge
                stamped.header.stamp = node.get_clock().now().to_msg()
                broadcaster.sendTransform(stamped)
            return bool(page.state.get("findings"))

        page.wait_for(send)
        frames = page.state["findings"][0]["frames"]
        assert "base" in frames
        page.send(op="mark", frames=frames)
        page.wait_for(lambda: send() and page.state["marked"] == frames)
        wait_until(lambda: send() and [2.0, 0.0, 0.0] in (boxes() or []), what="a box around base")
        page.send(op="mark", frames=frames)
        page.wait_for(lambda: send() and page.state["marked"] == [])
        wait_until(lambda: boxes() is None, what="no box")
        page.send(op="mark", frames=["map"])  # no finding concerns it alone
        page.send(op="names", on=False)
        page.wait_for(lambda: not page.state["with_names"])
        page.wait_for(lambda: send() and page.state["marked"] == [])
    finally:
        for other in others:
            other.destroy_node()


def test_time_is_turned_back_and_live_again(node: Node, viewer: Viewer, page: Page) -> None:
    feed(node, viewer)
    page.wait_for(lambda: page.row("base"))
    wait_until(
        lambda: axes_of(viewer) == [0.0], what="the fixed frame alone"
    )  # what moves is out of date, so it is grey
    page.send(op="hold", stamp_ns=str(103_500_000_000))
    page.wait_for(lambda: page.state["held_ns"] == "103500000000")
    wait_until(lambda: axes_of(viewer) == [0.0, 2.5, 2.5, 3.0], what="the frames of the held time")
    page.send(op="hold", stamp_ns="1")  # before the history: its first time
    page.wait_for(lambda: page.state["held_ns"] == str(101 * 10**9))
    page.send(op="hold", stamp_ns=None)
    page.wait_for(lambda: page.state["held_ns"] is None)


def test_fixed_frame_is_chosen_and_a_trail_drawn(node: Node, viewer: Viewer, page: Page) -> None:
    feed(node, viewer)
    page.send(op="hold", stamp_ns=str(111 * 10**9))
    page.send(op="fixed_frame", frame="base")
    page.send(op="trail", frame="map", on=True)
    page.wait_for(lambda: page.state["fixed_frame"] == "base" and page.state["trails"] == ["map"])
    wait_until(lambda: axes_of(viewer) == [-10.0, 0.0, 0.0, 0.5], what="the frames in base")
    wait_until(lambda: shown(viewer, "/trails/0") is not None, what="the trail")
    assert shown(viewer, "/trails/0").points[:, 0, 0].tolist() == [-x for x in range(10)]
    page.send(op="trail", frame="map", on=False)
    wait_until(lambda: shown(viewer, "/trails/0") is None, what="the trail's end")


def test_length_of_axes_is_changed(node: Node, viewer: Viewer, page: Page) -> None:
    feed(node, viewer)
    page.send(op="hold", stamp_ns=str(111 * 10**9))
    wait_until(lambda: shown(viewer, "/frames/arrows") is not None, what="arrows")
    page.send(op="axes", length=2.0)
    for name, attribute, value in (("axes", "batched_scales", 2.0), ("arrows", "shaft_radius", 0.04)):
        wait_until(
            lambda: getattr(shown(viewer, f"/frames/{name}"), attribute, 0) == pytest.approx(value),  # noqa: B023
            what=f"other {name}",
        )


def test_cloud_is_shown_where_it_stood_and_a_closed_page_reads_nothing(
    node: Node, viewer: Viewer, open_page: OpenPage
) -> None:
    publisher = node.create_publisher(PointCloud2, "/points", 10)
    page = open_page(viewer)
    feed(node, viewer)
    page.wait_for(lambda: page.display("/points"))
    assert publisher.get_subscription_count() == 0
    page.show("/points", publisher)
    points = np.zeros(2, [("x", "<f4"), ("y", "<f4"), ("z", "<f4")])
    for sec in (104, 108):
        message = cloud(points, "base")
        message.header.stamp.sec = sec
        publisher.publish(message)

    def place() -> float | None:
        handle = shown(viewer, "/displays/0/0")
        return None if handle is None else float(handle.position[0] + handle.points[0, 0])

    wait_until(lambda: place() == 7.0, what="the newest cloud")
    page.send(op="hold", stamp_ns=str(106 * 10**9))
    wait_until(
        lambda: place() == 3.0, what="the cloud before"
    )  # where base was at 104, not where it is at 106
    page.socket.close()
    wait_until(lambda: publisher.get_subscription_count() == 0, what="the reader's end")
    again = open_page(viewer)
    wait_until(lambda: publisher.get_subscription_count() == 1, what="the reader of the next page")
    assert again.wait_for(lambda: again.display("/points"))["on"]


@pytest.mark.parametrize("reliability", [ReliabilityPolicy.RELIABLE, ReliabilityPolicy.BEST_EFFORT])
def test_each_of_many_markers_that_come_at_once_is_shown(
    node: Node, viewer: Viewer, page: Page, reliability: ReliabilityPolicy
) -> None:
    feed(node, viewer)
    publisher = node.create_publisher(Marker, "/markers", QoSProfile(depth=1000, reliability=reliability))
    page.show("/markers", publisher)
    for number in range(300):
        made = marker(Marker.CUBE, number, header=header("map", sec=200 - number % 3))
        publisher.publish(made)
    wait_until(lambda: shown(viewer, "/displays/0/299"), what="300 nodes")
    page.send(op="hold", stamp_ns=str(105 * 10**9))
    page.wait_for(lambda: page.state["held_ns"] == str(105 * 10**9))
    wait_until(lambda: shown(viewer, "/displays/0/0") is None, what="the time before the markers")
    page.send(op="hold", stamp_ns=None)
    wait_until(lambda: shown(viewer, "/displays/0/299"), what="all markers again")
    assert shown(viewer, "/displays/0/300") is None


def test_display_says_why_it_shows_nothing(node: Node, viewer: Viewer, page: Page) -> None:
    publisher = node.create_publisher(PoseStamped, "/pose", 10)
    feed(node, viewer)
    page.show("/pose", publisher)
    publisher.publish(PoseStamped(header=header("nowhere"), pose=pose()))
    page.wait_for(lambda: "nowhere" in page.display("/pose")["status"])
    publisher.publish(PoseStamped(header=header("map", 2), pose=pose(math.nan)))
    page.wait_for(lambda: "not finite" in page.display("/pose")["status"])
    publisher.publish(PoseStamped(header=header("map", 3), pose=pose(1.0)))
    page.wait_for(lambda: page.display("/pose")["status"] == "")


def test_image_is_a_file_that_browsers_show(node: Node, viewer: Viewer, page: Page) -> None:
    publisher = node.create_publisher(Image, "/camera", 10)
    page.show("/camera", publisher)
    publisher.publish(Image(header=header(), width=4, height=3, step=12, encoding="rgb8", data=bytes(36)))

    def picture() -> bytes:
        with urllib.request.urlopen(f"{viewer.pages.address}image?topic=/camera") as response:
            return response.read()

    assert wait_until(lambda: picture().startswith(b"\xff\xd8\xff")) is None
    publisher.publish(Image(header=header(sec=2), width=4, height=3, step=1, encoding="rgb8", data=b"1"))

    def is_refused() -> bool:
        return picture() == b"" and "don't fit" in page.wait_for(lambda: page.display("/camera"))["status"]

    def take_and_ask() -> bool:
        page.state = {}
        page.wait_for(lambda: page.state)
        return is_refused()

    wait_until(take_and_ask, what="the sentence about the image")
    publisher.publish(
        Image(header=header(sec=3), width=4, height=3, step=12, encoding="rgb8", data=bytes(36))
    )
    wait_until(picture, what="the next picture")
    page.state = {}
    page.wait_for(lambda: page.state and page.display("/camera")["status"] == "")


def test_fault_of_one_display_ends_that_one_alone(
    node: Node, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    publishers = {topic: node.create_publisher(PoseStamped, topic, 10) for topic in ("/bad", "/good")}
    feed(node, viewer)
    for topic, publisher in publishers.items():
        page.show(topic, publisher)

    def fail(*_: object) -> None:
        raise ZeroDivisionError("a fault")

    monkeypatch.setattr(viewer.view.feed("/bad").display, "shapes", fail)
    for publisher in publishers.values():
        publisher.publish(PoseStamped(header=header("map"), pose=pose()))
    page.wait_for(lambda: "ZeroDivisionError: a fault" in page.display("/bad")["status"])
    page.wait_for(lambda: page.display("/good")["status"] == "")


HALF = "\ud800"
WRONG: list[tuple[dict[str, Any], str]] = [
    ({"op": "no_such"}, "no such command"),
    ({}, "op has to be a text"),
    ({"op": ["select"]}, "op has to be a text"),
    ({"op": "select", "frame": "nowhere"}, "there is no frame"),
    ({"op": "select", "frame": 3}, "frame has to be a text"),
    ({"op": "mark", "frames": "map"}, "frames has to be a list"),
    ({"op": "hold", "stamp_ns": 5}, "stamp_ns has to be"),
    ({"op": "display", "topic": "/nothing", "on": True}, "there is no topic"),
    ({"op": "display", "topic": "/rosout", "on": True}, "no display shows rcl_interfaces/msg/Log"),
    ({"op": "play", "on": True}, "nothing to play"),
    ({"op": "axes", "length": 1e9}, "axes are from"),
    ({"op": "drive", "topic": "/cmd_vel", "ahead": 1, "left": 0}, "nobody subscribes"),
    ({"op": "floor", "tool": "goal", "from": [0, 0], "to": [1, 1]}, "has not told its camera"),
    (
        {"op": "set_parameter", "node": "/x", "name": "y", "value": "1"},
        "there is no server of /x/set_parameters",
    ),
    ({"op": "axes", "length": 10**400}, "has to be a finite number"),
    ({"op": "drive", "topic": "/cmd_vel", "ahead": -(10**400), "left": 0}, "has to be a finite number"),
    ({"op": "fixed_frame", "frame": HALF}, "without halves of surrogate pairs"),
    ({"op": "select", "frame": HALF}, "without halves"),
    ({"op": "trail", "frame": HALF, "on": True}, "without halves"),
    ({"op": "mark", "frames": [HALF]}, "without halves"),
    ({"op": "display", "topic": HALF, "on": True}, "without halves"),
    ({"op": "choose", "topic": HALF, "choice": ""}, "without halves"),
    ({"op": "plot", "topic": HALF, "field": HALF, "on": True}, "without halves"),
    ({"op": "plot", "topic": HALF, "field": HALF, "on": False}, "without halves"),
    ({"op": "plot_fields", "topic": HALF}, "without halves"),
    ({"op": HALF}, "without halves"),
    ({"op": "parameters", "node": HALF}, "without halves"),
    ({"op": "form", "what": "topic", "name": HALF, "type": HALF}, "without halves"),
]


def test_wrong_commands_get_a_sentence_and_the_viewer_goes_on(node: Node, page: Page) -> None:
    page.wait_for(lambda: page.state)
    node.get_logger().info("so that /rosout is there")
    for command, sentence in WRONG:
        assert sentence in page.ask("error", **command), command
    for text in ("no JSON", "[1]", "[" * 10_000, '{"op": "names", "on": NaN}', b"\x00\xff"):
        page.answers.clear()
        page.socket.send(text)
        assert page.answer("error")
    page.send(op="names", on=False)
    page.wait_for(lambda: page.state["with_names"] is False)


def test_command_that_raises_anything_ends_in_a_sentence_for_its_page(
    viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(_: object) -> None:
        raise MemoryError

    monkeypatch.setattr(viewer.view, "command", fail)
    assert page.ask("error", op="names", on=True).startswith("MemoryError")
    monkeypatch.undo()
    page.send(op="names", on=False)
    page.wait_for(lambda: page.state["with_names"] is False)


def test_camera_that_is_none_is_not_taken_and_the_one_before_stays(viewer: Viewer, page: Page) -> None:
    scene = Scene(urlsplit(viewer.pages.address).port or 0, page)
    nan = math.nan
    for changed in (
        {"wxyz": (0.0, 0.0, 0.0, 0.0)},
        {"wxyz": (nan, nan, nan, nan)},
        {"wxyz": "abc"},
        {"wxyz": (1.0,)},
        {"position": (nan, nan, nan)},
        {"position": [[1, 2], [3], [4]]},
        {"look_at": (1e308, 0.0, 0.0)},
        {"fov": "x"},
        {"image_height": 0},
        {"image_height": "\x1b[31m"},
    ):
        scene.tell_camera(**changed)
    click = {
        "type": "SceneNodeClickMessage",
        "name": "/frames/axes",
        "instance_index": 2**62,
        "ray_origin": None,
    }
    for message in (click, {"type": "SceneNodeDragMessage", "name": 7}, {"type": ["x"]}, {}):
        scene.socket.send(msgspec.msgpack.encode(message))
    assert "not told its camera" in page.ask(
        "error", op="floor", tool="goal", **{"from": [0, 0], "to": [1, 1]}
    )
    scene.tell_camera()
    wait_until(
        lambda: viewer._server.camera(page.name), what="the camera, by the connection that is still open"
    )
    scene.tell_camera(wxyz=(0.0, 0.0, 0.0, 0.0))
    scene.tell_camera(position=(1.0, 1.0, 7.0))
    wait_until(
        lambda: (at := viewer._server.camera(page.name)) is not None and at.position[2] == 7.0,
        what="the next camera",
    )
    assert "position" in page.ask("layout", op="layout")
    scene.abort()


def test_end_of_a_page_is_taken_among_too_many_commands(
    viewer: Viewer, monkeypatch: pytest.MonkeyPatch
) -> None:
    ended: list[str] = []
    monkeypatch.setattr(viewer._live.forms, "forget", ended.append)
    monkeypatch.setattr(viewer._live.driving, "forget", lambda page: ended.append(f"drive {page}"))
    monkeypatch.setattr(program, "MAX_COMMANDS", 0)
    viewer._queue_command("a", {"op": "closed"})  # a page's own words
    viewer._queue_command("b", page_server.CLOSED)
    wait_until(lambda: ended, what="the page's end")
    assert ended == ["drive b", "b"]


def test_reader_and_writer_that_the_wire_refuses_end_nothing(
    node: Node, viewer: Viewer, page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object) -> None:
        raise WireError("there is no room for a reader")

    node.create_publisher(PoseStamped, "/pose", 1)
    page.wait_for(lambda: any(row["topic"] == "/pose" for row in page.state["displays"]))
    topics: Any = viewer._topics
    full = argparse.Namespace(graph=topics._participant.graph, create_reader=refuse)
    monkeypatch.setattr(topics, "_participant", full)
    for command in (
        {"op": "display", "topic": "/pose", "on": True},
        {"op": "plot", "topic": "/pose", "field": "pose.position.x", "on": True},
    ):
        assert page.ask("error", **command) == "there is no room for a reader"
    page.send(op="names", on=False)
    page.wait_for(lambda: page.state["with_names"] is False)


def test_what_was_asked_for_at_the_start_and_is_not_shown_is_printed(
    node: Node, viewer: Viewer, open_page: OpenPage, capsys: pytest.CaptureFixture[str]
) -> None:
    node.create_publisher(Int64, "/count", 1)
    plots = tuple(PlotLayout("/count", f"field_{number}") for number in range(13))
    viewer.view.apply(Layout(displays=(DisplayLayout("/count"),), plots=plots))
    page = open_page(viewer)
    page.wait_for(lambda: page.state and not viewer.view._wanted)
    printed = capsys.readouterr().err
    assert "tfloom: field_12 of /count is not shown: there are 12 plots already\n" in printed
    assert "tfloom: /count is not shown: no display shows std_msgs/msg/Int64\n" in printed


def test_too_long_a_command_ends_its_page_alone(viewer: Viewer, open_page: OpenPage) -> None:
    page, other = open_page(viewer), open_page(viewer)
    page.socket.send("x" * (page_server.MAX_COMMAND_BYTES + 1))
    with pytest.raises(ConnectionClosed):
        take_all(page.socket)
    other.send(op="axes", length=0.7)
    other.wait_for(lambda: other.state["axes_m"] == 0.7)


def test_ten_pages_show_the_same_and_more_than_the_limit_are_refused(
    viewer: Viewer, open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    pages = [open_page(viewer) for _ in range(10)]
    assert len({page.name for page in pages}) == 10
    pages[0].send(op="axes", length=0.9)
    for page in pages:
        page.wait_for(lambda page=page: page.state["axes_m"] == 0.9)
    monkeypatch.setattr(page_server, "MAX_PAGES", 10)
    with pytest.raises(InvalidStatus, match="503"):
        open_page(viewer)


def test_page_that_takes_nothing_gets_the_newest_state_and_no_queue(
    viewer: Viewer, open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    slow, other = open_page(viewer), open_page(viewer)
    monkeypatch.setattr(viewer, "_publish", lambda: None)  # the states below are the only ones
    count = 60
    for number in range(count):
        viewer.pages.publish({"number": number, "padding": "x" * 1_000_000})
        other.wait_for(lambda number=number: other.state.get("number") == number)
    taken = []

    def is_newest() -> bool:
        taken.append(slow.state.get("number"))
        return slow.state.get("number") == count - 1

    slow.wait_for(is_newest)
    # What waited in the buffers of the sockets and of the client was taken; the rest was never kept for it.
    assert len({number for number in taken if number is not None}) < count * 3 / 4


def test_viser_is_reached_through_the_relay_alone(viewer: Viewer, page: Page) -> None:
    from viser import __version__

    inner = viewer._server.inner
    viser = [f"viser-v{__version__}"]
    with pytest.raises(TimeoutError):
        socket.create_connection(inner.address, timeout=0.3)
    # Where a system has no filters, the key remains.
    with connect("ws://viser", sock=inner.connect(10.0), subprotocols=viser, proxy=None) as stranger:
        with pytest.raises(ConnectionClosed) as closed:
            take_all(stranger)
        assert closed.value.rcvd.code == 1008
    scene = viewer.pages.address.replace("http://", "ws://") + "scene/ws?page="
    with connect(scene + page.name, subprotocols=viser, proxy=None) as opened:
        assert isinstance(opened.recv(timeout=10.0), bytes)
    with connect(scene + "unknown", proxy=None) as opened, pytest.raises(ConnectionClosed):
        opened.recv(timeout=10.0)


def test_requests_of_other_sites_and_for_other_files_are_refused(viewer: Viewer) -> None:
    address = viewer.pages.address

    def status(path: str = "", **headers: str) -> int:
        request = urllib.request.Request(address + path, headers=headers)
        try:
            with urllib.request.urlopen(request) as response:
                return int(response.status)
        except urllib.error.HTTPError as error:
            return error.code

    assert status() == 200
    assert status("page.js") == 200
    assert status(Host="evil.example") == 403
    assert status(Origin="http://evil.example") == 403
    # Lower case, and an image in a page of another site, for which browsers send no Origin.
    place = urlsplit(address)
    head = f"GET {{}} HTTP/1.1\r\nHost: {place.netloc}\r\n{{}}: {{}}\r\n\r\n"
    for path, name, value in (
        ("/api", "origin", "http://evil.example"),
        ("/image?topic=/camera", "sec-fetch-site", "cross-site"),
        ("http://evil.example/", "accept", "*/*"),
    ):
        with socket.create_connection((place.hostname, place.port), timeout=10.0) as client:
            client.sendall(head.format(path, name, value).encode())
            assert client.recv(100).startswith(b"HTTP/1.1 403"), path
    assert status("image?topic=/camera", **{"Sec-Fetch-Site": "same-origin"}) == 204
    for path in ("../page_server.py", "%2e%2e/page_server.py", "page/../../view.py", "scene/../x"):
        assert status(path) == 404
    with urllib.request.urlopen(address) as response:
        policy = response.headers["Content-Security-Policy"]
        assert response.headers["Cross-Origin-Resource-Policy"] == "same-origin"
    assert "script-src 'self'" in policy
    assert "unsafe-inline" not in policy


def test_other_addresses_than_loopback_need_the_token(
    viewer: Viewer, monkeypatch: pytest.MonkeyPatch
) -> None:
    from tfloom.common.access import Access

    monkeypatch.setattr("tfloom.common.access.is_loopback", lambda _: False)
    access = viewer.pages._access = Access("127.0.0.1", viewer.pages._port)
    assert f"?token={access.token}" in viewer.pages.address
    with pytest.raises(urllib.error.HTTPError, match="403"):
        urllib.request.urlopen(viewer.pages.address.partition("?")[0])
    with urllib.request.urlopen(viewer.pages.address) as response:
        cookie = response.headers["Set-Cookie"]
    assert "HttpOnly" in cookie
    bare = viewer.pages.address.partition("?")[0].replace("http://", "ws://") + "api"
    with pytest.raises(InvalidStatus, match="403"):
        connect(bare, proxy=None)
    with connect(bare, additional_headers={"Cookie": cookie.partition(";")[0]}, proxy=None) as opened:
        assert "page" in str(opened.recv(timeout=10.0))


def test_log_of_nodes_with_texts_as_they_are(node: Node, viewer: Viewer, open_page: OpenPage) -> None:
    page = open_page(viewer)
    wait_until(lambda: node.count_subscribers("/rosout") >= 1, what="the reader of /rosout")
    node.get_logger().warning(EVIL)
    line = page.wait_for(lambda: [line for line in page.log if line["text"] == EVIL])[0]
    assert (line["level"], line["name"]) == (30, "feeder")
    late = open_page(viewer)
    late.wait_for(lambda: any(line["text"] == EVIL for line in late.log))


def test_graph_of_nodes(node: Node, page: Page) -> None:
    publisher = node.create_publisher(Twist, "/cmd_vel", 10)
    subscription = node.create_subscription(Twist, "/cmd_vel", lambda _: None, 10)

    def has_both() -> bool:
        graph = page.ask("graph", op="graph")
        names = [vertex["name"] for vertex in graph["vertices"]]
        pairs = [[names[first], names[second]] for first, second in graph["edges"]]
        return ["/feeder", "/cmd_vel"] in pairs and ["/cmd_vel", "/feeder"] in pairs

    wait_until(has_both, what="both ends of /cmd_vel")
    assert not any("_tfloom_view" in vertex["name"] for vertex in page.answers[-1]["graph"]["vertices"])
    del publisher, subscription


def test_parameters_are_read_and_set(spun: Node, page: Page) -> None:
    spun.declare_parameter("speed", 1.5)

    def values() -> dict[str, str]:
        page.answers.clear()
        page.send(op="parameters", node="/feeder")
        page.wait_for(lambda: page.answers)
        found = page.answers[0].get("parameters", {"values": []})
        return {value["name"]: value["value"] for value in found["values"]}

    wait_until(lambda: values().get("speed") == "1.5", what="the parameter")
    assert (
        page.ask("done", op="set_parameter", node="/feeder", name="speed", value="2.5")
        == "speed of /feeder is 2.5"
    )
    assert spun.get_parameter("speed").value == 2.5
    assert "did not set speed" in page.ask(
        "error", op="set_parameter", node="/feeder", name="speed", value="fast"
    )


def test_what_the_page_shows_of_a_parameter_can_be_set_again(spun: Node, page: Page) -> None:
    given = {
        "text": "0888",
        "word": "y",
        "list": "[a]",
        "no_text": "",
        "texts": ["a, b", "", "1"],
        "doubles": [math.inf, 1.0],
        "no_doubles": [],
    }
    for name, value in given.items():
        spun.declare_parameter(name, [0.5] if value == [] else value)
    spun.set_parameters([Parameter("no_doubles", Parameter.Type.DOUBLE_ARRAY, [])])

    def shown() -> dict[str, str]:
        page.answers.clear()
        page.send(op="parameters", node="/feeder")
        page.wait_for(lambda: page.answers)
        found = page.answers[0].get("parameters", {"values": []})
        return {value["name"]: value["value"] for value in found["values"]}

    wait_until(lambda: given.keys() <= shown().keys(), what="the parameters")
    texts = shown()
    others = {
        "text": "x",
        "word": "x",
        "list": "x",
        "no_text": "x",
        "texts": ["x"],
        "doubles": [2.0],
        "no_doubles": [2.0],
    }
    spun.set_parameters([Parameter(name, value=value) for name, value in others.items()])
    for name, value in given.items():
        page.ask("done", op="set_parameter", node="/feeder", name=name, value=texts[name])
        assert list(spun.get_parameter(name).value) == list(value)
        assert spun.get_parameter(name).type_ is Parameter(name, value=others[name]).type_


def test_parameter_that_is_shown_in_part_is_not_editable(spun: Node, page: Page) -> None:
    given = {"short": "x" * 2000, "long": "x" * 3000, "n" * 300: "of a long name"}
    for name, value in given.items():
        spun.declare_parameter(name, value)

    def rows() -> dict[str, bool]:
        page.answers.clear()
        page.send(op="parameters", node="/feeder")
        page.wait_for(lambda: page.answers)
        found = page.answers[0].get("parameters", {"values": []})
        return {value["name"][:5]: value["is_editable"] for value in found["values"]}

    wait_until(lambda: "short" in rows(), what="the parameters")
    found = rows()
    assert (found["short"], found["long"], found["n" * 5]) == (True, False, False)


def test_tools_publish_what_was_dragged(spun: Node, viewer: Viewer) -> None:
    goals: list[PoseStamped] = []
    spun.create_subscription(PoseStamped, "/goal_pose", goals.append, 10)
    live = viewer._live
    assert live is not None
    tools = Tools(live.participant, next(iter(live.participant.graph.nodes())), lambda: 5 * 10**9)
    try:
        tools.open()
        wait_until(lambda: spun.count_publishers("/goal_pose") >= 1)

        def is_there() -> bool:
            said = tools.use("goal", "map", (1.0, 2.0), (1.0, 3.0))
            assert said == "goal (1.00, 2.00), 90° in map, published on /goal_pose"
            return bool(goals)

        wait_until(is_there, what="the goal")
    finally:
        tools.close()
    assert (goals[0].header.frame_id, goals[0].header.stamp.sec) == ("map", 5)
    assert (goals[0].pose.position.x, goals[0].pose.position.y) == (1.0, 2.0)
    assert goals[0].pose.orientation.z == pytest.approx(math.sin(math.pi / 4))


def test_layout_is_applied_and_saved(node: Node, viewer: Viewer, open_page: OpenPage, tmp_path: Path) -> None:
    layout = Layout(
        fixed_frame="base",
        axes_m=0.7,
        displays=(DisplayLayout("/points", "b"), DisplayLayout("/later")),
        plots=(PlotLayout("/points", "width", 1),),
        camera=ViewPoint((1.0, 2.0, 3.0), (0.0, 0.0, 0.0)),
    )
    viewer.apply(layout)
    publisher = node.create_publisher(PointCloud2, "/points", 10)
    page = open_page(viewer)
    assert page.camera == {"position": [1.0, 2.0, 3.0], "look_at": [0.0, 0.0, 0.0]}
    feed(node, viewer)
    wait_until(lambda: publisher.get_subscription_count() == 1, what="the reader of the display and the plot")
    points = np.zeros(2, [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("a", "<f4"), ("b", "<f4")])
    publisher.publish(cloud(points, "base"))
    page.wait_for(
        lambda: (page.display("/points") or {}).get("choice") == "b" and page.display("/points")["choices"]
    )
    assert (page.state["fixed_frame"], page.state["axes_m"]) == ("base", 0.7)
    page.wait_for(lambda: page.state["plots"][0]["shown"] == 2.0)
    page.send(op="layout")
    saved = tmp_path / "saved.yaml"
    saved.write_text(page.answer("layout"))
    # The scene has told no camera, because this page has no scene. What is shown has its kind.
    shown = DisplayLayout("/points", "b", kind="PointCloud2"), DisplayLayout("/later")
    assert read_layout(saved) == (layout._replace(camera=None, displays=shown), [])
    viewer.layout_path = tmp_path / "written.yaml"
    assert "written.yaml" in page.ask("done", op="layout")
    assert (tmp_path / "written.yaml").read_text() == saved.read_text()
    viewer.layout_path = tmp_path / "no" / "such"
    assert "can't write" in page.ask("error", op="layout")


def test_wrench_is_drawn_by_the_settings_of_a_file_of_rviz(
    node: Node, viewer: Viewer, open_page: OpenPage, tmp_path: Path
) -> None:
    file = tmp_path / "foot.rviz"
    display = "{Class: rviz_default_plugins/Wrench, Force Arrow Scale: 0.1, Topic: {Value: /wrench}}"
    file.write_text(f"Visualization Manager: {{Displays: [{display}], Global Options: {{Fixed Frame: map}}}}")
    viewer.apply(read_layout(file)[0])
    publisher = node.create_publisher(WrenchStamped, "/wrench", 10)
    open_page(viewer)
    feed(node, viewer)
    wait_until(lambda: publisher.get_subscription_count() == 1, what="the reader of the display")
    publisher.publish(wrench((50.0, 0.0, 0.0), (0.0, 0.0, 1.0), "base", 111))
    wait_until(lambda: shown(viewer, "/displays/0/1") is not None, what="the torque")
    assert shown(viewer, "/displays/0/0").vertices[:, 0].max() == pytest.approx(6.5)
    assert shown(viewer, "/displays/0/0").position[0] == 10.0
    assert shown(viewer, "/displays/0/1").vertices[:, 2].max() == pytest.approx(2.6)


def test_camera_of_a_layout_stands_at_its_frame_at_once_or_when_the_frame_is_known(
    node: Node, viewer: Viewer, open_page: OpenPage
) -> None:
    above = ViewPoint((-1.0, 0.0, 2.0), (0.0, 0.0, 0.5))
    viewer.apply(Layout(fixed_frame="map", camera=above, camera_frame="laser"))
    early = open_page(viewer)
    assert early.camera == {"position": [-1.0, 0.0, 2.0], "look_at": [0.0, 0.0, 0.5]}
    scene = Scene(urlsplit(viewer.pages.address).port, early)
    scene.tell_camera()
    feed(node, viewer)
    scene.wait_for(lambda: {"position", "look_at"} <= scene.camera.keys())
    first = scene.camera["position"]
    assert first[0] >= -0.5  # the laser is 0.5 m before the base, which may have stood anywhere on its way
    assert (first[1], first[2]) == (0.0, 2.0)
    late = open_page(viewer)
    assert late.camera == {"position": [9.5, 0.0, 2.0], "look_at": [10.5, 0.0, 0.5]}
    scene.abort()


def test_camera_of_a_layout_turns_with_its_frame_if_that_is_wanted(node: Node, viewer: Viewer) -> None:
    broadcaster = StaticTransformBroadcaster(node)
    turned = transform("map", "base", 1, 4.0)
    turned.transform.rotation.z = turned.transform.rotation.w = math.sqrt(0.5)
    broadcaster.sendTransform(turned)
    wait_until(lambda: viewer.view.buffer.has_frame("base"), what="the frame")
    behind = Layout(
        fixed_frame="map", camera=ViewPoint((-1.0, 0.0, 2.0), (0.0, 0.0, 0.0)), camera_frame="base"
    )
    viewer.apply(behind)
    assert viewer.view.placed(behind) == ViewPoint((3.0, 0.0, 2.0), (4.0, 0.0, 0.0))
    placed = viewer.view.placed(behind._replace(camera_turns=True))
    assert placed is not None
    assert placed.position == pytest.approx((4.0, -1.0, 2.0))


def test_images_of_a_camera_are_exchanged_in_its_pyramid_at_the_time_that_is_shown(
    node: Node, viewer: Viewer, page: Page
) -> None:
    infos = node.create_publisher(CameraInfo, "/camera/camera_info", 10)
    images = node.create_publisher(Image, "/camera/image", 10)
    feed(node, viewer)
    page.show("/camera/camera_info", infos)
    page.show("/camera/image", images)

    def level_shown() -> int | None:
        image = getattr(shown(viewer, "/displays/0/1"), "image", None)  # a new handle has none for a moment
        return None if image is None else int(image[0, 0, 0])

    k = [2.0, 0, 1.0, 0, 2.0, 1.0, 0, 0, 1]
    nodes = set()
    for sec, level in ((104, 40), (108, 200)):
        infos.publish(CameraInfo(header=header("base", sec), width=4, height=2, k=k))
        data = bytes([level]) * 24
        images.publish(
            Image(header=header("base", sec), width=4, height=2, step=12, encoding="rgb8", data=data)
        )
        wait_until(lambda level=level: level_shown() == level, what="the image")
        nodes |= {id(shown(viewer, f"/displays/0/{part}")) for part in (0, 1)}
    assert len(nodes) == 2  # they are changed, not replaced
    page.send(op="hold", stamp_ns=str(105 * 10**9))
    wait_until(lambda: level_shown() == 40, what="the image before")
    page.send(op="choose", topic="/camera/camera_info", choice="no image")
    wait_until(lambda: level_shown() is None, what="the pyramid alone")


def test_wire_that_refuses_the_log_or_the_tools_leaves_the_rest_and_the_page_says_why(
    node: Node, viewer: Viewer, open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    live = viewer._live
    assert live is not None

    def refuse() -> None:
        raise WireError("planted refusal")

    with monkeypatch.context() as patch:
        patch.setattr(live.log, "open", refuse)
        patch.setattr(live.tools, "open", refuse)
        page = open_page(viewer)
        for said in ("the log of the graph is not read", "the topics of the tools are not open"):
            page.wait_for(lambda said=said: f"{said}: planted refusal" in [line["text"] for line in page.log])
        feed(node, viewer)
        page.wait_for(lambda: page.row("laser"))
        page.socket.close()
        wait_until(lambda: not viewer._is_open, what="the end of the page")
    again = open_page(viewer)
    wait_until(lambda: node.count_subscribers("/rosout") >= 1, what="the reader of /rosout")
    assert again.state


def test_trails_that_a_layout_has_too_many_of_are_named_on_the_page(
    viewer: Viewer, open_page: OpenPage
) -> None:
    viewer.apply(Layout(trails=tuple(f"frame_{number}" for number in range(22))))
    page = open_page(viewer)
    assert len(page.state["trails"]) == 20
    said = page.wait_for(lambda: [line["text"] for line in page.log if "trails" in line["text"]])
    assert said == ["there are at most 20 trails; those of these frames are not shown: frame_20, frame_21"]


def test_new_page_gets_the_last_lines_and_an_open_one_each_line_once_also_after_the_first_are_dropped(
    viewer: Viewer, open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(viewer._live.log, "take", list)  # the lines below are the only ones
    page = open_page(viewer)
    number = itertools.count()
    for count in (MAX_LINES - 100, 300, MAX_LINES + 50, 1):
        added = [str(next(number)) for _ in range(count)]
        page.log.clear()
        viewer.pages.add_lines([{"text": text} for text in added], MAX_LINES)
        page.wait_for(lambda page=page: page.log)
        # Of more than are kept, the last ones.
        assert [line["text"] for line in page.log] == added[-MAX_LINES:]
        late = open_page(viewer)
        late.wait_for(lambda late=late: late.log)
        last = added[-1]
        assert late.log[-1]["text"] == last
        assert [int(line["text"]) for line in late.log] == list(range(int(last) - 499, int(last) + 1))
    assert len(viewer.pages._lines) == MAX_LINES


def test_tools_that_were_closed_are_opened_by_the_next_use(spun: Node, viewer: Viewer) -> None:
    live = viewer._live
    goals: list[PoseStamped] = []
    spun.create_subscription(PoseStamped, "/goal_pose", goals.append, 10)
    tools = Tools(live.participant, next(iter(live.participant.graph.nodes())), lambda: 5 * 10**9)
    others = spun.count_publishers("/goal_pose")
    for _ in range(2):
        tools.open()
        tools.open()
        wait_until(lambda: spun.count_publishers("/goal_pose") == others + 1, what="one publisher")
        goals.clear()
        wait_until(lambda: tools.use("goal", "map", (1.0, 2.0), (1.0, 3.0)) and goals, what="a goal")
        tools.close()
        wait_until(lambda: spun.count_publishers("/goal_pose") == others, what="no publisher")
    tools.close()


def test_connections_that_ask_for_nothing_sensible_print_nothing(
    domain_id: int, start_program: Callable[..., Program]
) -> None:
    view = start_program("tfloom", "view", "--no-open", "--port", "0")
    view.wait_for("Open http://127.0.0.1:")
    ports = [
        listener.laddr.port
        for listener in psutil.Process(view.process.pid).net_connections("tcp")
        if listener.status == psutil.CONN_LISTEN
    ]
    assert len(ports) >= 2  # that of pages, and viser's
    for port in ports:
        for data in (
            *(b"", b"GET", b"\x16\x03\x01\x00", b"GET / HTTP/1.1\r\n\r\n"),
            *(b"POST / HTTP/1.1\r\nContent-Length: 3\r\n\r\nabc", b"GET / HTTP/1.1\r\nX: " + b"y" * 100_000),
            b"GET /api HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\r\n",
        ):
            with suppress(ConnectionError), socket.create_connection(("127.0.0.1", port)) as stranger:
                stranger.sendall(data)
                stranger.shutdown(socket.SHUT_WR)
                while stranger.recv(65536):
                    pass
    view.signal(signal.SIGINT)
    assert view.wait() == 0
    assert len(view.lines) == 1, view.output


PICTURE_FOR_EVER = """\
import itertools, time
from tfloom.cli.main import main
from tfloom.viewer.shared_state import SharedView

def draw(self):
    print("draws", flush=True)
    for _ in range(2):  # a library for meshes catches any exception, and goes on in another way
        try:
            work_for_ever()
        except BaseException:
            print("goes on", flush=True)
    work_for_ever()

def work_for_ever():
    for number in itertools.count():
        time.sleep(0.001)

SharedView.draw = draw
sys.exit(main(["view", "--no-open", "--port", "0"]))
"""


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="needs a timer's signal")
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM"])
def test_picture_that_takes_for_ever_does_not_keep_the_program_from_its_end(
    domain_id: int, start_program: Callable[..., Program], name: str
) -> None:
    view = start_program(sys.executable, *python_with({}, PICTURE_FOR_EVER))
    address = view.wait_for("Open http://127.0.0.1:").removeprefix("Open http://")
    with connect(f"ws://{address}api", proxy=None):
        view.wait_for("draws")
        view.signal(getattr(signal, name))
        assert view.wait() == 0
    assert view.output.count("goes on") == 2
    assert "Traceback" not in view.output
