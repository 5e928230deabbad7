"""A viewer of a graph, and clients of its pages that are not browsers."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from tests.conftest import TIMEOUT_S

from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node

if TYPE_CHECKING:
    from websockets.sync.client import ClientConnection

    from tfloom.node.endpoints.publisher import Publisher
    from tfloom.viewer.program import Viewer

HAS_VISER = all(find_spec(name) is not None for name in ("viser", "websockets", "msgspec", "trimesh"))
collect_ignore = (
    []
    if HAS_VISER
    else [
        "test_busy_pages.py",
        "test_described.py",
        "test_driving.py",
        "test_drive_in_browser.py",
        "test_field_plots.py",
        "test_first_look.py",
        "test_forms.py",
        "test_mesh_files.py",
        "test_view.py",
        "test_hostile_view.py",
        "test_second_lives.py",
        "test_settings_in_browser.py",
        "test_pages.py",
        "test_published_joints.py",
        "test_recorded.py",
        "test_browser.py",
        "test_inline.py",
        "test_interactive_markers.py",
        "test_markers_in_browser.py",
        "test_open_ports.py",
        "test_page_scenes.py",
        "test_scene_in_browser.py",
        "test_textures.py",
        "test_viser_private.py",
    ]
)
"""Tests of pages need the extra `view`; those of what is shown do not."""

OWN_TYPES = Path(__file__).parents[1] / "cli" / "a_node_with_own_types.py"
"""A program with topics, services and actions of types that it alone has."""


class Page:
    """What a page's script does, without a scene."""

    def __init__(self, socket: ClientConnection) -> None:
        self.socket = socket
        self.name = ""
        self.camera: Any = None
        self.state: dict[str, Any] = {}
        self.log: list[dict[str, Any]] = []
        self.answers: list[dict[str, Any]] = []

    def send(self, **command: Any) -> None:
        self.socket.send(json.dumps(command))

    def wait_for(self, condition: Callable[[], Any], timeout_s: float = TIMEOUT_S) -> Any:
        """Take messages until a condition of what was taken is true; return its value."""
        end_s = time.monotonic() + timeout_s
        while not (value := condition()):
            assert time.monotonic() < end_s, f"timed out with {self.state} and {self.answers}"
            with suppress(TimeoutError):
                self.take(json.loads(self.socket.recv(timeout=0.1)))
        return value

    def take(self, message: dict[str, Any]) -> None:
        self.name = message.get("page", self.name)
        self.camera = message.get("camera", self.camera)
        self.state = message.get("state", self.state)
        self.log += message.get("log", [])
        if not message.keys() & {"page", "state", "log"}:
            self.answers.append(message)

    def answer(self, key: str) -> Any:
        """Wait for an answer, and return its value."""
        return self.wait_for(lambda: [message for message in self.answers if key in message])[0][key]

    def ask(self, key: str, /, **command: Any) -> Any:
        """Send a command, and return the value of its answer; earlier answers are forgotten."""
        self.answers.clear()
        self.send(**command)
        return self.answer(key)

    def show(self, topic: str, publisher: Publisher[Any]) -> None:
        """Switch a display on as soon as its topic is offered, and wait for its reader."""
        self.wait_for(lambda: self.display(topic))
        self.send(op="display", topic=topic, on=True)
        self.wait_for(publisher.get_subscription_count)

    def row(self, frame: str) -> dict[str, Any] | None:
        return next((row for row in self.state.get("rows", []) if row["frame"] == frame), None)

    def display(self, topic: str) -> dict[str, Any] | None:
        return next((row for row in self.state.get("displays", []) if row["topic"] == topic), None)


@contextmanager
def running_node(domain_id: int, name: str, **options: Any) -> Iterator[Node]:
    """Have a node with its own context for the block."""
    context = Context()
    context.init(args=[], domain_id=domain_id)
    node = Node(name, context=context, **options)
    try:
        yield node
    finally:
        node.destroy_node()
        context.try_shutdown()


@contextmanager
def spinning(*nodes: Node) -> Iterator[None]:
    """Spin nodes of one context on a thread for the block."""
    executor = SingleThreadedExecutor(context=nodes[0].context)
    for node in nodes:
        executor.add_node(node)
    thread = threading.Thread(target=executor.spin)
    thread.start()
    try:
        yield
    finally:
        executor.shutdown()
        thread.join(TIMEOUT_S)


@contextmanager
def running(viewer: Viewer) -> Iterator[Viewer]:
    """Run a viewer on a thread for the block, at a free port."""
    viewer.pages.start("127.0.0.1", 0)
    over = threading.Event()
    thread = threading.Thread(target=viewer.run, args=(over.is_set,))
    thread.start()
    try:
        yield viewer
    finally:
        over.set()
        thread.join(TIMEOUT_S)


@pytest.fixture
def node(domain_id: int) -> Iterator[Node]:
    with running_node(domain_id, "feeder") as made:
        yield made


@pytest.fixture
def spun(node: Node) -> Iterator[Node]:
    """The node, spun on a thread."""
    with spinning(node):
        yield node


@pytest.fixture
def viewer(domain_id: int) -> Iterator[Viewer]:
    """A viewer of the test's domain."""
    from tfloom.rmw.backends import open_participant
    from tfloom.viewer.live import live_viewer

    participant = open_participant(domain_id)
    try:
        with (
            live_viewer(participant, topics=("/tf", "/tf_static"), history_s=30.0) as made,
            running(made),
        ):
            yield made
    finally:
        participant.close()


@pytest.fixture
def open_page() -> Iterator[Callable[[Viewer], Page]]:
    """Open pages of viewers, which are closed with the test."""
    from websockets.sync.client import connect

    with ExitStack() as stack:

        def open_one(viewer: Viewer) -> Page:
            address = viewer.pages.address.replace("http://", "ws://") + "api"
            page = Page(stack.enter_context(connect(address, max_size=None, proxy=None, ping_interval=None)))
            page.wait_for(lambda: page.state)
            return page

        yield open_one


@pytest.fixture
def page(viewer: Viewer, open_page: Callable[[Viewer], Page]) -> Page:
    return open_page(viewer)


@pytest.fixture(scope="module")
def scene_server() -> Iterator[Any]:
    """Viser's server, which the tests of a file share."""
    from tfloom.viewer.scene_server import SceneServer

    made = SceneServer()
    yield made
    made.stop()


@pytest.fixture
def stage(scene_server: Any) -> Iterator[Any]:
    """A view of transforms and messages that the test gives."""
    from tests.viewer.stages import Stage

    yield Stage(scene_server)
    scene_server.scene.reset()
