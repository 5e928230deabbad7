"""A node on the in-process wire, OpenCV hidden or wanted, and what OpenCV answered."""

from __future__ import annotations

import random
import sys
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.sensing import opencv_golden

from tfloom.node.context.context import Context
from tfloom.node.node import Node
from tfloom.sensing import cv_types, opencv


@pytest.fixture
def local_context(monkeypatch: pytest.MonkeyPatch) -> Iterator[Context]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    context = Context()
    context.init(args=[], domain_id=random.randrange(200))
    yield context
    context.try_shutdown()


@pytest.fixture
def make_node(local_context: Context) -> Iterator[Callable[..., Node]]:
    nodes: list[Node] = []

    def make(name: str, **options: object) -> Node:
        nodes.append(Node(name, context=local_context, **options))
        return nodes[-1]

    yield make
    for node in nodes:
        node.destroy_node()


@pytest.fixture
def node(make_node: Callable[..., Node]) -> Node:
    return make_node("under_test")


@pytest.fixture
def without_opencv(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Have the code under test find no OpenCV, wherever it is installed."""
    monkeypatch.setitem(sys.modules, "cv2", None)
    cached = (opencv.find_opencv, cv_types.channels_shift)
    for function in cached:
        function.cache_clear()
    yield
    for function in cached:
        function.cache_clear()


@pytest.fixture(scope="session")
def recorded() -> opencv_golden.Recorded:
    """Return inputs, and what OpenCV made of them."""
    return opencv_golden.recorded()


@pytest.fixture
def cv2() -> Any:
    """Give OpenCV itself."""
    return pytest.importorskip("cv2", reason="needs OpenCV: pip install opencv-python-headless")
