"""A view without a graph: its transforms and messages are a test's, its scene is viser's."""

from __future__ import annotations

import json
from collections.abc import Mapping
from itertools import count
from typing import Any

import pytest
from tests.tf2_tools.recordings import transform

from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.watch.recorded import observe_recorded
from tfloom.tf2_tools.watch.sources import Still
from tfloom.viewer.page_server import _json
from tfloom.viewer.scene import Scene
from tfloom.viewer.scene_server import SceneServer
from tfloom.viewer.shared_state import SharedView
from tfloom.viewer.topic_log import Cursor, TopicLog

S = 1_000_000_000


class KeptTopics:
    """Topics whose messages the test adds."""

    def __init__(self) -> None:
        self.logs: dict[str, TopicLog] = {}
        self.classes: dict[str, type[Any]] = {}
        self.numbers = count()
        self.silences: dict[str, str] = {}
        self.beginnings = 0

    def add(self, topic: str, message: Any, stamp_ns: int = S) -> None:
        self.classes[topic] = type(message)
        self.log(topic).add(stamp_ns, cdr.encode(message))

    def log(self, topic: str) -> TopicLog:
        def decode(data: bytes) -> Any:
            return cdr.decode(self.classes[topic], data)

        new = TopicLog(60 * S, decode, numbers=self.numbers, on_left=lambda: self.logs.pop(topic, None))
        return self.logs.setdefault(topic, new)

    def types(self) -> Mapping[str, str]:
        return {topic: made._TYPE_NAME for topic, made in self.classes.items()}

    def open(self, topic: str, depth: int = 0) -> Cursor:
        return self.log(topic).open(depth)

    def message_class(self, topic: str) -> type[Any]:
        return self.classes[topic]

    def silence(self, topic: str, type_name: str) -> str:
        return self.silences.get(topic, "")

    def poll(self) -> None:
        pass

    def begin_anew(self) -> None:
        self.beginnings += 1


class Stage:
    """A view of transforms and topics that the test gives, and its scene."""

    def __init__(self, server: SceneServer) -> None:
        self.server = server
        self.topics: Any = KeptTopics()
        self.scene = Scene(server.scene, lambda _: None)
        self.reports: list[str] = []
        self.moves: list[Any] = []
        self.view = self.view_of(Buffer())

    def view_of(self, buffer: Buffer, **options: Any) -> SharedView:
        buffer.set_log_callback(None)
        seen = observe_recorded(
            [("/tf", stamp_ns, cdr.encode(TFMessage(transforms=[made]))) for stamp_ns, made in self.moves],
            "a test",
            buffer=buffer,
        )
        report = self.reports.append
        options = {"is_simulated": True, **options}
        return SharedView(
            Still(seen, buffer),
            self.topics,
            self.scene,
            is_live=True,
            report=report,
            **options,
        )

    def move(self, parent: str, child: str, *xs: float) -> None:
        """Let a frame be at each x in turn, a second apart."""
        for second, x in enumerate(xs, 1):
            self.moves.append((second * S, transform(parent, child, second * S, (x, 0.0, 0.0))))
        self.view = self.view_of(Buffer())

    def draw(self) -> dict[str, Any]:
        """Draw twice, so that what is looked at seldom is seen, and return what pages get."""
        for _ in range(2):
            self.view._next_look_s = self.view._next_trail_s = self.view._next_diagnosis_s = 0.0
            self.view.draw()
        state: dict[str, Any] = json.loads(_json(self.view.snapshot()), parse_constant=pytest.fail)
        return state

    def node(self, name: str) -> Any:
        return self.server.scene.get_handle_by_name(name)

    def status(self, topic: str) -> str:
        feed = self.view.feed(topic)
        assert feed is not None
        return feed.status

    def drawn(self, topic: str) -> list[Any]:
        """Return the nodes of a display that are in the scene."""
        number = self.scene._display_numbers[topic]
        nodes = (self.node(f"/displays/{number}/{index}") for index in range(20))
        return [node for node in nodes if node is not None]
