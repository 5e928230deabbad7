"""A graph's other node, and bridges as processes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from importlib.util import find_spec
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.conftest import Program

    from tfloom.node.node import Node

HAS_SDK = find_spec("foxglove") is not None and find_spec("websockets") is not None
collect_ignore_glob = [] if HAS_SDK else ["test_*.py"]


@pytest.fixture
def node(domain_id: int) -> Iterator[Node]:
    """Another node of the graph, which is spun."""
    from tests.foxglove.clients import spun_node

    with spun_node(domain_id, "other") as made:
        yield made


@pytest.fixture
def start_bridge(start_program: Callable[..., Program]) -> Callable[..., tuple[Program, int]]:
    """Start bridges as processes, with parameters: `start_bridge("tls:=true")`; return each with its port."""
    from tests.foxglove.clients import start_bridge_by

    return partial(start_bridge_by, start_program)
