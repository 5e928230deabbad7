"""`doctor` on Zenoh: other sessions, and definitions that differ."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import closing

import pytest
from tests.conftest import Program
from tests.zenoh_ports import NEEDS_ZENOH, use_port_of

from tfloom.cli.doctor.checks import check_domain
from tfloom.cli.doctor.finding import Verdict
from tfloom.cli.doctor.peers import SharedDomain, check_peers
from tfloom.interfaces.std_msgs.msg import String
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName
from tfloom.rmw.qos import QoS
from tfloom.rmw.typed_names import topic_of

pytestmark = NEEDS_ZENOH
OTHER_HASH = "RIHS01_" + 64 * "2"


@pytest.fixture(autouse=True)
def zenoh_environment(domain_id: int, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    with use_port_of(domain_id):
        yield


def test_sessions_are_counted_and_no_vendor_of_dds_is_named(start_program: Callable[..., Program]) -> None:
    assert check_peers(SharedDomain())[:2] == (Verdict.OK, "no other session on the domain")
    program = start_program("tfloom", "run", "demo_nodes_cpp", "talker")
    program.wait_for("Publishing")
    finding = check_peers(SharedDomain())
    assert finding[:3] == (Verdict.OK, "other sessions: 1; topics and services pass", "")
    assert list(finding.details.values()) == ["/talker"]


def test_definitions_that_differ_are_named_with_the_nodes_of_each() -> None:
    chatter = topic_of(String, "/chatter")
    with closing(open_participant()) as here, closing(open_participant()) as there:
        here.add_node(NodeName("/", "talker"))
        there.add_node(NodeName("/", "listener"))
        here.create_writer(NodeName("/", "talker"), chatter, QoS())
        there.create_reader(NodeName("/", "listener"), chatter._replace(type_hash=OTHER_HASH), QoS())
        finding = check_peers(SharedDomain())
    assert finding.verdict is Verdict.WARNING
    assert finding.summary == (
        "other sessions: 2; definitions differ, so that nothing passes between some nodes, on /chatter "
        "(std_msgs/msg/String)"
    )
    nodes = {chatter.type_hash: "/talker", OTHER_HASH: "/listener"}
    assert finding.details["/chatter std_msgs/msg/String"] == "; ".join(
        f"{type_hash} of {nodes[type_hash]}" for type_hash in sorted(nodes)
    )


def test_no_stock_ros_is_said_to_need_the_same_range(domain_id: int) -> None:
    assert check_domain()[:3] == (Verdict.OK, f"domain {domain_id}, discovery range LOCALHOST", "")
