"""A graph's other node, and clients of bridges."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from importlib.util import find_spec
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.viewer.foxglove_bridge.clients import Client

    from tfloom.node.node import Node
    from tfloom.viewer.foxglove_bridge.bridge import FoxgloveBridge

HAS_SDK = find_spec("foxglove") is not None and find_spec("websockets") is not None
collect_ignore_glob = [] if HAS_SDK else ["test_*.py"]


@pytest.fixture
def node(domain_id: int) -> Iterator[Node]:
    """Another node of the graph, which is spun."""
    from tests.viewer.foxglove_bridge.clients import running_node

    with running_node(domain_id, "other") as made:
        yield made


@pytest.fixture
def client_of() -> Iterator[Callable[[FoxgloveBridge], Client]]:
    from tests.viewer.foxglove_bridge.clients import Client

    with ExitStack() as stack:

        def open_one(bridge: FoxgloveBridge) -> Client:
            assert bridge.server is not None
            client = Client(bridge.server.port)
            stack.callback(client.socket.close)
            client.wait_for(lambda: client.info, "serverInfo")
            return client

        yield open_one
