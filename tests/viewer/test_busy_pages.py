"""Many pages, pages that take nothing, and pages that go while something is sent to them."""

from __future__ import annotations

import asyncio
import time
import urllib.error
import urllib.request
from collections.abc import Callable
from contextlib import ExitStack, closing, suppress

import msgspec
import numpy as np
import psutil
import pytest
from tests.conftest import TIMEOUT_S, Program, wait_until
from tests.viewer.conftest import Page
from tests.viewer.messages import cloud
from tests.viewer.scenes import Scene, connect_scene, take_all
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.sensor_msgs.msg import PointCloud2
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.node import Node
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.qos import QoS
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.viewer import page_server
from tfloom.viewer.forms.filling import stamp_of_ns
from tfloom.viewer.page_server import MAX_AHEAD, MAX_NOTED, _Pace
from tfloom.viewer.program import Viewer

OpenPage = Callable[[Viewer], Page]
POINTS = 100_000
AXES = ("/frames/axes", "batched_positions")


def port_of(viewer: Viewer) -> int:
    return viewer.pages._port


class Frames:
    """Publishes a frame that is at another place each time."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._broadcaster = TransformBroadcaster(node)
        self.x = 0.0

    def move(self) -> None:
        self.x += 1.0
        message = TransformStamped(child_frame_id="moving")
        message.header.frame_id = "world"
        message.header.stamp = self._node.get_clock().now().to_msg()
        message.transform.translation.x = self.x
        message.transform.rotation.w = 1.0
        self._broadcaster.sendTransform(message)


def shows(scene: Scene, frames: Frames) -> bool:
    """Return whether a scene shows the newest place, which is published anew until it does."""
    frames.move()
    positions = scene.arrays.get(AXES)
    return positions is not None and bool(positions.max() > frames.x - 20.0 and positions.max() > 1.0)


def points(number: int) -> PointCloud2:
    """Return a cloud whose points all have another place, and whose first one's x is a number."""
    table = np.zeros(POINTS, [("x", "<f4"), ("y", "<f4"), ("z", "<f4")])
    table["x"] = number
    table["y"] = np.random.default_rng(number).normal(size=POINTS)
    message = cloud(table, "world")
    message.header.stamp = stamp_of_ns(time.time_ns())  # messages of one time would all stay in the history
    return message


def show_cloud(page: Page, publisher: Publisher[PointCloud2], frames: Frames) -> None:
    def is_there() -> bool:
        frames.move()
        return page.display("/points") is not None and page.row("moving") is not None

    page.wait_for(is_there)
    page.show("/points", publisher)


def test_ten_pages_and_one_that_takes_nothing(node: Node, viewer: Viewer, open_page: OpenPage) -> None:
    """Nine scenes stay fresh while the tenth reads nothing, and it has the newest when it reads again."""
    frames = Frames(node)
    with ExitStack() as stack:
        scenes = [Scene(port_of(viewer), open_page(viewer)) for _ in range(10)]
        for scene in scenes:
            stack.callback(scene.socket.close)
        *others, stuck = scenes
        for scene in others:
            scene.wait_for(lambda scene=scene: shows(scene, frames))
        for _ in range(300):
            frames.move()
        for scene in others:
            scene.wait_for(lambda scene=scene: shows(scene, frames))
        stuck.wait_for(lambda: shows(stuck, frames))


def test_scene_that_takes_nothing_costs_no_queue(
    domain_id: int, node: Node, start_program: Callable[..., Program]
) -> None:
    """Clouds for it don't wait in memory; when it reads again, it gets few of them, and soon the newest."""
    publisher = node.create_publisher(PointCloud2, "/points", 1)
    frames = Frames(node)
    program = start_program("tfloom", "view", "--no-open", "--port", "0", "--history", "1")
    address = program.wait_for("http://127.0.0.1:").partition("http://127.0.0.1:")[2]
    port = int(address.partition("/")[0])
    assert "token" not in program.output
    with connect(f"ws://127.0.0.1:{port}/api", max_size=None, proxy=None, ping_interval=None) as socket:
        page = Page(socket)
        page.wait_for(lambda: page.state)
        scene = Scene(port, page)
        show_cloud(page, publisher, frames)
        process = psutil.Process(program.process.pid)
        count = 30

        def send(number: int) -> None:
            """Publish a cloud until the viewer has drawn it: its state has the number of the cloud's points."""
            publisher.publish(points(number))
            page.state = {}
            page.wait_for(lambda: page.state)

        for number in range(5):
            send(number)
        before = process.memory_info().rss
        for number in range(5, 5 + count):
            send(number)
        grown = process.memory_info().rss - before
        assert grown < count * POINTS * 12 / 2, f"{grown} bytes more for {count} clouds that nobody takes"
        last = 1000.0
        shown: set[float] = set()

        def has_the_last() -> bool:
            publisher.publish(points(int(last)))
            shown.update(float(array[0]) for (_, key), array in scene.arrays.items() if key == "points")
            return last in shown

        scene.wait_for(has_the_last)
        assert len(shown) < count / 2, "clouds were kept for a page that took none"
        scene.socket.close()


def test_scene_that_draws_slowly_gets_the_newest_cloud_when_it_has_drawn_one(
    node: Node, viewer: Viewer, open_page: OpenPage
) -> None:
    """A browser takes all that comes, and would collect what it can't draw: it is sent no more until it has drawn."""
    publisher = node.create_publisher(PointCloud2, "/points", 1)
    frames = Frames(node)
    page = open_page(viewer)
    scene = Scene(port_of(viewer), page)
    show_cloud(page, publisher, frames)
    shown: set[float] = set()

    def take() -> set[float]:
        shown.update(float(array[0]) for (_, key), array in scene.arrays.items() if key == "points")
        return shown

    def draw(number: int) -> None:
        """Publish a cloud until the viewer has it in its scene; take what comes meanwhile."""
        publisher.publish(points(number))

        def is_drawn() -> bool:
            node = viewer._server.scene.get_handle_by_name("/displays/0/0")
            return bool(node is not None and node.points[0, 0] == number)

        end_s = time.monotonic() + TIMEOUT_S
        while not is_drawn():
            assert time.monotonic() < end_s, number
            with suppress(TimeoutError):
                message = scene.socket.recv(timeout=0.02)
                assert isinstance(message, bytes)
                scene._take(message)
            take()

    draw(1)
    scene.wait_for(lambda: 1.0 in take())
    for wrong in ("all", 1.5, -3, 10**9, None):  # a page may say anything
        scene.socket.send(msgspec.msgpack.encode({"type": "TfloomDrawn", "count": wrong}))
    draw(2)
    scene.wait_for(lambda: 2.0 in take())
    scene.tell_drawn(10**9)
    for number in range(3, 23):
        draw(number)
    assert len(shown) < 10, sorted(shown)

    def has_the_last() -> bool:
        scene.tell_drawn(10**9)
        return 22.0 in take()

    scene.wait_for(has_the_last)
    assert len(shown) < 12, sorted(shown)


def test_pages_that_are_killed_while_a_cloud_is_sent_leave_nothing(
    node: Node, viewer: Viewer, open_page: OpenPage
) -> None:
    publisher = node.create_publisher(PointCloud2, "/points", 1)
    frames = Frames(node)
    lasting = open_page(viewer)
    show_cloud(lasting, publisher, frames)
    loop = viewer.pages._loop
    before = len(asyncio.all_tasks(loop))
    for number in range(6):
        page = open_page(viewer)
        scene = Scene(port_of(viewer), page)
        publisher.publish(points(number))
        scene.wait_for(lambda scene=scene: scene.updates)
        publisher.publish(points(number + 100))
        if number % 2:
            scene.abort()
            page.socket.close()
        else:
            page.socket.close()
            scene.abort()
    wait_until(lambda: viewer.pages.page_count == 1)
    wait_until(lambda: len(asyncio.all_tasks(loop)) <= before, what="the end of the tasks of closed pages")
    wait_until(lambda: not viewer._server._server.get_clients(), what="the end of viser's clients")
    assert len(viewer._server._clients) <= 1
    lasting.send(op="axes", length=0.6)
    lasting.wait_for(lambda: lasting.state["axes_m"] == 0.6)


def test_page_has_one_scene_which_ends_with_it(viewer: Viewer, page: Page) -> None:
    """A page can't open scenes without number, and a scene that outlives its page would cost what a page does."""
    scenes = [connect_scene(port_of(viewer), page.name) for _ in range(5)]
    assert isinstance(scenes[-1].recv(timeout=10.0), bytes)
    for scene in scenes[:-1]:
        with closing(scene), pytest.raises(ConnectionClosed):
            take_all(scene)
    wait_until(lambda: len(viewer._server._server.get_clients()) <= 1)
    page.socket.close()
    with closing(scenes[-1]), pytest.raises(ConnectionClosed):
        take_all(scenes[-1])
    wait_until(lambda: not viewer._server._server.get_clients())


def test_last_page_of_the_limit_has_its_scene(
    viewer: Viewer, open_page: OpenPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(page_server, "MAX_PAGES", 2)
    _, last = open_page(viewer), open_page(viewer)
    with closing(connect_scene(port_of(viewer), last.name)) as scene:
        assert isinstance(scene.recv(timeout=10.0), bytes)


EVIL = "<script>alert(1)</script>"


def test_names_of_nodes_and_topics_are_data(domain_id: int, viewer: Viewer, open_page: OpenPage) -> None:
    """A program that is not a ROS node may give any name; pages get it as text, and their policy allows no script."""
    participant = open_participant(domain_id)
    try:
        participant.add_node(NodeName("/", EVIL))
        participant.create_writer(NodeName("/", EVIL), Topic("/evil", String._TYPE_NAME, ""), QoS())
        page = open_page(viewer)

        def has_node() -> bool:
            return any(EVIL in vertex["name"] for vertex in page.ask("graph", op="graph")["vertices"])

        wait_until(has_node, what="the node")
    finally:
        participant.close()


REMOTE = """
import sys
from tfloom.common import access
access.is_loopback = lambda _: False
from tfloom.cli.main import main
raise SystemExit(main(["view", "--no-open", "--host", "127.0.0.1", "--port", "0"]))
"""
"""The program as with an address of another interface, of which a test uses none."""


def test_program_asks_for_the_token_and_says_so(start_program: Callable[..., Program]) -> None:
    program = start_program("python", "-c", REMOTE)
    line = program.wait_for("http://127.0.0.1:")
    address = line[line.index("http://") :].split()[0]
    bare, _, token = address.partition("?token=")
    assert token
    program.wait_for("it has a token, and is not encrypted")
    for wrong in (bare, f"{bare}?token=wrong", f"{bare}page.js", f"{bare}scene/"):
        with pytest.raises(urllib.error.HTTPError, match="403"):
            urllib.request.urlopen(wrong, timeout=20.0)
    with pytest.raises(InvalidStatus, match="403"):
        connect(bare.replace("http://", "ws://") + "api", proxy=None)
    with urllib.request.urlopen(address, timeout=20.0) as response:
        assert response.status == 200


def test_scene_that_never_says_what_it_draws_costs_no_memory_and_is_not_waited_for() -> None:
    async def waits(pace: _Pace) -> bool:
        task = asyncio.ensure_future(pace.wait())
        await asyncio.sleep(0)
        is_waiting = not task.done()
        task.cancel()
        return is_waiting

    async def run() -> None:
        pace, count = _Pace(), 10 * MAX_NOTED
        for _ in range(count):
            pace.note_sent(1000)
        assert len(pace._sizes) == MAX_NOTED
        assert not await waits(pace)
        pace.note_drawn(count - MAX_AHEAD - 1)  # from now on it says so
        assert len(pace._sizes) == MAX_AHEAD + 1
        assert await waits(pace)
        pace.note_drawn(-5)
        assert await waits(pace)
        pace.note_drawn(count - MAX_AHEAD)
        assert not await waits(pace)
        pace.note_drawn(1 << 80)
        assert not pace._sizes

    asyncio.run(run())
