"""A search for a type among the nodes that use it, step by step, on a graph of which the test decides what is known."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from tests.rosidl.test_described import described, individual
from tests.rosidl.workspaces import write_files

from tfloom._native import ReadyQueue
from tfloom.rmw.base import EndpointInfo, NodeName, Topic
from tfloom.rmw.errors import WireError
from tfloom.rmw.qos import QoS
from tfloom.rmw.shared import peer_types
from tfloom.rmw.shared.peer_types import MAX_NODES, TypeSearch

HASH = f"RIHS01_{64 * '0'}"
PLAN = "secret_msgs/msg/Plan"


class Wire:
    """A participant and its graph, with nodes that can't be asked."""

    def __init__(self) -> None:
        self.graph = self
        self.has_arrived = False
        self.ends: list[EndpointInfo] = []
        self.asked: list[str] = []

    def is_whole(self) -> bool:
        return self.has_arrived

    def raw_endpoints(self) -> list[EndpointInfo]:
        return self.ends

    def service_ends(self) -> list[Any]:
        return []

    def create_requester(self, _: NodeName, service: Any, __: QoS) -> Any:
        self.asked.append(service.name)
        raise WireError(f"no place for {service.name}")

    def add(self, node: NodeName | None, type_hash: str = HASH) -> None:
        topic = Topic("rt/plan", "secret_msgs::msg::dds_::Plan_", type_hash)
        self.ends.append(EndpointInfo(topic, node, is_writer=True, gid=bytes(16), qos=QoS()))


class Answered:
    """A request that has got a response."""

    def __init__(self, response: Any) -> None:
        self.take = lambda: response

    def ask(self, _: bytes, **__: float) -> None:
        pass

    def close(self) -> None:
        pass


def search_on(wire: Any, patience_s: float = 60.0) -> TypeSearch:
    return TypeSearch(wire, NodeName("/", "me"), PLAN, "msg", ReadyQueue(), patience_s=patience_s)


def test_search_waits_for_the_node_of_an_endpoint_that_is_known_before_it() -> None:
    wire = Wire()
    wire.add(None)
    search = search_on(wire)
    assert [search.step(), search.step()] == [False, False]
    wire.ends.clear()
    wire.add(NodeName("/", "planner"))
    assert search.step()
    assert wire.asked == ["/planner/get_type_description"]
    assert search.reasons == ["no place for /planner/get_type_description"]


@pytest.mark.parametrize(
    ("part", "reason"),
    [
        ("gone_msgs/Gone x\n", "there is no definition of 'gone_msgs/msg/Gone'"),
        ("int33 x\n", "part_msgs/msg/Part.msg:1:1: 'int33' is neither"),
    ],
    ids=["missing", "invalid"],
)
def test_search_ends_with_a_reason_where_a_definition_here_can_not_be_used(
    part: str, reason: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As where a workspace is not sourced that another one needs."""
    write_files(tmp_path / "share" / "part_msgs" / "msg", {"Part.msg": part})
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    description, hashes = described(
        individual(PLAN, part=(1, 0, "part_msgs/msg/Part")), individual("part_msgs/msg/Part")
    )
    response = SimpleNamespace(successful=True, type_description=description)
    monkeypatch.setattr(peer_types, "ServiceRequest", lambda *_: Answered(response))
    wire = Wire()
    wire.add(NodeName("/", "planner"), hashes[PLAN])
    search = search_on(wire)
    assert search.step()
    (told,) = search.reasons
    assert told.startswith("the description from /planner can't be used: ")
    assert reason in told


@pytest.mark.parametrize(("is_whole", "patience_s"), [(True, 60.0), (False, 0.0)])
def test_search_is_over_where_nobody_uses_the_type(is_whole: bool, patience_s: float) -> None:
    wire = Wire()
    wire.has_arrived = is_whole
    search = search_on(wire, patience_s)
    assert search.step()
    assert (search.reasons, wire.asked) == ([], [])


def test_few_of_many_nodes_are_asked_and_each_has_its_reason() -> None:
    wire = Wire()
    for number in range(MAX_NODES + 2):
        wire.add(NodeName("/", f"planner_{number}"))
    search = search_on(wire)
    assert search.step()
    assert len(search.reasons) == len(wire.asked) == MAX_NODES
