"""The graph of a participant, and what it announces: byte for byte as a real ROS 2."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable
from importlib.util import find_spec
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from tests.conftest import Program

from tfloom._native import (
    DdsParticipant,
    DdsWriter,
    ReadyQueue,
    dds_knows_address,
    dds_read_versions,
    dds_version,
)
from tfloom.rmw.base import NodeName, Service, Topic
from tfloom.rmw.cyclone import discovery_info
from tfloom.rmw.cyclone.config import configuration
from tfloom.rmw.cyclone.graph import CycloneGraph
from tfloom.rmw.cyclone.library import find_library
from tfloom.rmw.cyclone.wire import open_participant
from tfloom.rmw.qos import (
    INFINITE_NS,
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoS,
    ReliabilityPolicy,
)
from tfloom.rmw.services import MIN_DEPTH
from tfloom.rmw.topic_names import key_values, topic_from_dds, type_from_dds, type_to_dds

GOLDEN = json.loads((Path(__file__).parents[1] / "golden" / "wire_jazzy_cyclonedds.json").read_text("utf-8"))
OBSERVE = Path(__file__).parent / "programs" / "observe.py"
needs_package = pytest.mark.skipif(
    find_spec("cyclonedds") is None,
    reason="the peer is the Python package cyclonedds, which has no wheel here",
)

TRANSIENT_LOCAL = DurabilityPolicy.TRANSIENT_LOCAL
RECORDED = {
    ("publication", "rt/turtle1/pose"): QoS(depth=7),
    ("publication", "rt/turtle1/color_sensor"): QoS(depth=7),
    ("publication", "rt/tf_static"): QoS(durability=TRANSIENT_LOCAL, depth=1),
    ("publication", "rt/rosout"): QoS(durability=TRANSIENT_LOCAL, depth=1000, lifespan_ns=10_000_000_000),
    ("publication", "rt/parameter_events"): QoS(depth=1000),
    ("publication", "rt/turtle1/rotate_absolute/_action/status"): QoS(durability=TRANSIENT_LOCAL, depth=1),
    ("subscription", "rt/turtle1/cmd_vel"): QoS(depth=7),
    ("subscription", "rt/parameter_events"): QoS(depth=1000),
}


def recorded_endpoint(kind: str, topic_name: str) -> dict[str, Any]:
    return next(end for end in GOLDEN[kind] if end["topic_name"] == topic_name)


def recorded_topic(kind: str, topic_name: str) -> Topic:
    end = recorded_endpoint(kind, topic_name)
    user_data = next(policy for policy in end["qos"] if "typehash=" in policy)
    type_hash = key_values(user_data.partition("'")[2].encode())["typehash"]
    return Topic(topic_from_dds(topic_name) or "", type_from_dds(end["type_name"]), type_hash)


KILL = {
    (kind, name): recorded_endpoint(kind, name)
    for kind, name in (("subscription", "rq/killRequest"), ("publication", "rr/killReply"))
}
"""The recorded ends of a server."""


@pytest.fixture(scope="module")
def observed(module_domain_id: int, start_module_program: Callable[..., Program]) -> list[dict[str, Any]]:
    """Return what a plain DDS participant discovers of a node with the recorded endpoints."""
    participant, node = open_participant(module_domain_id), NodeName("/tests", "here")
    participant.add_node(node)
    for (kind, name), qos in RECORDED.items():
        create = participant.create_writer if kind == "publication" else participant.create_reader
        create(node, recorded_topic(kind, name), qos)
    hashes = [re.search("RIHS01_[0-9a-f]+", str(end["qos"]))[0] for end in KILL.values()]
    participant.create_responder(node, Service("/kill", "turtlesim/srv/Kill", *hashes), QoS())
    participant.create_writer(node, Topic("/last", "std_msgs/msg/String", ""), QoS())
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CYCLONEDDS_URI", configuration())
        program = start_module_program("python", OBSERVE, str(module_domain_id), str(len(RECORDED) + 1))
        assert program.wait() == 0, program.output
    participant.close()
    return [json.loads(line) for line in program.lines]


@needs_package
def test_endpoints_match_those_of_a_real_ros(observed: list[dict[str, Any]]) -> None:
    seen = {(entry["kind"], entry.get("topic_name")): entry for entry in observed}
    node_list = {("publication", "ros_discovery_info"), ("subscription", "ros_discovery_info")}
    for kind, name in RECORDED.keys() | node_list:
        expected, got = recorded_endpoint(kind, name), seen[kind, name]
        assert got["type_name"] == expected["type_name"]
        assert set(expected["qos"]) <= set(got["qos"]), (kind, name)


@needs_package
def test_service_endpoints_match_those_of_a_real_ros(
    observed: list[dict[str, Any]], deviations: dict[str, dict[str, str]]
) -> None:
    seen = {(entry["kind"], entry.get("topic_name")): entry for entry in observed}
    server_ids = set()
    for key, expected in KILL.items():
        got = seen[key]
        assert got["type_name"] == expected["type_name"]
        *policies, user_data = expected["qos"]
        if "services-history" in deviations and key[0] == "subscription":
            policies.remove("Policy.History.KeepLast(depth=10)")
            policies.append(f"Policy.History.KeepLast(depth={MIN_DEPTH})")
        assert set(policies) <= set(got["qos"])
        (told,) = (policy for policy in got["qos"] if policy.startswith("Policy.Userdata"))
        prefix, server_id, rest = re.fullmatch(r"(.*serviceid=)([ 0-9a-f.]+)(;.*)", told).groups()
        assert user_data.startswith(prefix)
        assert user_data.endswith(rest)
        assert server_id.count(".") == 15
        assert server_id.startswith(" 1.10.")
        server_ids.add(server_id)
    assert len(server_ids) == 1


@needs_package
def test_the_participant_announces_its_enclave(observed: list[dict[str, Any]]) -> None:
    announced = [entry["qos"] for entry in observed if entry["kind"] == "participant"]
    recorded = GOLDEN["participant"][0]["user_data"]
    assert [qos for qos in announced if set(recorded) <= set(qos)]


def test_nodes_and_endpoints_of_another_process_are_listed(
    participant, start_peer, topic, node, wait_until
) -> None:
    qos = QoS(
        ReliabilityPolicy.BEST_EFFORT,
        TRANSIENT_LOCAL,
        HistoryPolicy.KEEP_LAST,
        7,
        1_000_000_000,
        INFINITE_NS,
        LivelinessPolicy.MANUAL_BY_TOPIC,
        2_000_000_000,
    )
    peer = start_peer()
    _, gid = peer("writer", topic, qos)
    graph = participant.graph
    wait_until(lambda: any(end.node for end in graph.endpoints()))
    assert graph.nodes() == [NodeName("/peers", "peer_0"), node]
    (info,) = graph.endpoints()
    assert (info.topic, info.node, info.is_writer) == (topic, NodeName("/peers", "peer_0"), True)
    assert info.gid.hex() == gid
    assert repr(info.qos) == repr(qos), "the policies have their classes"


def test_own_nodes_and_endpoints_are_listed_at_once(participant, node, topic) -> None:
    graph = participant.graph
    assert graph.nodes() == [node]
    reader = participant.create_reader(node, topic, QoS())
    assert [(end.topic, end.node, end.gid) for end in graph.endpoints()] == [(topic, node, reader.gid)]
    reader.close()
    assert graph.endpoints() == []
    participant.remove_node(node)
    assert graph.nodes() == []


def test_twin_nodes_are_listed_twice(participant, node) -> None:
    participant.add_node(node)
    assert participant.graph.nodes() == [node, node]
    participant.remove_node(node)
    assert participant.graph.nodes() == [node]


def test_changes_grow_and_are_posted(participant, start_peer, topic, wait_until) -> None:
    queue = ReadyQueue()
    participant.graph.notify(queue, 9)
    peer = start_peer()
    counts = [participant.graph.changes()]
    for verb in ("writer", "reader"):
        end, _ = peer(verb, topic, QoS())
        wait_until(lambda: participant.graph.changes() > counts[-1])
        assert queue.wait(5_000_000_000) == [9]
        counts.append(participant.graph.changes())
        queue.wait(0)
        peer("close", end)
        wait_until(lambda: participant.graph.changes() > counts[-1])
        counts.append(participant.graph.changes())
    assert all(before < after for before, after in pairwise(counts))


def test_topics_of_other_programs_are_not_ros_topics(participant, domain_id, wait_until) -> None:
    bare = DdsParticipant(find_library(), domain_id, configuration(), b"")
    writer = DdsWriter(bare, "plain_topic", "plain::Type", QoS(), b"")
    ros_like = DdsWriter(bare, "rt/half_ros", "plain::Type", QoS(), b"typehash")
    wait_until(participant.graph.endpoints)
    (info,) = participant.graph.endpoints()
    assert (info.topic, info.node) == (Topic("/half_ros", "plain::Type", ""), None)
    for end in (writer, ros_like, bare):
        end.close()


@pytest.mark.parametrize(
    "junk", [b"\0\1\0\0junk", b"\0\1\0\0" + b"\xff" * 64, b"\0\1\0\0" + bytes(16) + b"\xff" * 4]
)
def test_invalid_node_list_does_not_hide_others(
    participant, domain_id, node, wait_until, junk: bytes
) -> None:
    bare = DdsParticipant(find_library(), domain_id, configuration(), b"")
    qos = QoS(durability=TRANSIENT_LOCAL, depth=1)
    writer = DdsWriter(bare, discovery_info.TOPIC_NAME, type_to_dds(discovery_info.TYPE_NAME), qos, b"")
    wait_until(writer.matched_count)
    writer.write(junk[:4] + bare.gid + junk[20:] if len(junk) > 20 else junk)
    told = discovery_info.encode(bare.gid, [discovery_info.NodeEnds(NodeName("/", "good"), [], [])])
    assert participant.graph.nodes() == [node]
    writer.write(told)
    wait_until(lambda: participant.graph.nodes() == [NodeName("/", "good"), node])
    writer.close()
    bare.close()
    wait_until(lambda: participant.graph.nodes() == [node])


def test_opening_does_not_change_the_environment(participant) -> None:
    import os

    assert "CYCLONEDDS_URI" not in os.environ


def test_range_off_discovers_nothing_and_is_not_discovered(
    domain_id, monkeypatch, start_peer, wait_until
) -> None:
    seen, seeing = start_peer(), start_peer()
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF")
    hidden = open_participant(domain_id)
    hidden.add_node(NodeName("/", "hidden"))
    for peer in (seen, seeing):
        wait_until(lambda p=peer: p("nodes") == ["/peers/peer_0", "/peers/peer_1"])
    assert hidden.graph.nodes() == [NodeName("/", "hidden")]
    hidden.close()


PARTICIPANT, WRITER, OTHER = (bytes([number]) * 16 for number in (1, 2, 3))
QUALITY = (1, 1, 1, 1, 0, 0, 1, 0)
LIST = discovery_info.encode(PARTICIPANT, [discovery_info.NodeEnds(NodeName("/", "a"), [], [WRITER])])

NO_NODES = discovery_info.encode(PARTICIPANT, [])


def writer_on(topic: bytes, quality: tuple[int, ...] = QUALITY) -> tuple[object, ...]:
    return (WRITER, PARTICIPANT, True, topic, b"std_msgs::msg::dds_::Empty_", b"", quality)


def graph_of(*snapshots: tuple[list[Any], list[Any]]) -> CycloneGraph:
    """Return a graph that reads these participants and endpoints, one after the other."""
    graph = CycloneGraph.__new__(CycloneGraph)
    graph._native = SimpleNamespace(snapshot=iter(snapshots).__next__)
    graph._endpoints = {}
    return graph


@pytest.mark.parametrize(
    ("user_data", "node_list", "endpoints", "is_whole"),
    [
        (b"enclave=/;", LIST, [writer_on(b"rt/x")], True),
        (b"enclave=/;", LIST, [], False),
        (b"enclave=/;", b"", [writer_on(b"rt/x")], False),
        (b"enclave=/;", b"", [writer_on(b"rr/xReply")], False),
        (b"enclave=/;", b"", [writer_on(b"ros_discovery_info")], False),
        (b"enclave=/;", b"", [], False),
        (b"enclave=/;", NO_NODES, [writer_on(b"ros_discovery_info")], True),
        (b"", b"", [writer_on(b"rt/x")], True),
    ],
    ids=[
        "all",
        "an end is to come",
        "a list",
        "a list, of a service",
        "no list",
        "nothing",
        "no nodes",
        "no ROS",
    ],
)
def test_announced_but_missing_entities_make_the_graph_incomplete(
    user_data: bytes, node_list: bytes, endpoints: list[tuple[object, ...]], is_whole: bool
) -> None:
    graph = graph_of(([(PARTICIPANT, user_data, node_list)], endpoints))
    assert graph._read(1).is_whole is is_whole


def test_an_endpoint_is_decoded_anew_only_where_it_or_its_node_has_changed() -> None:
    silent, listed = [(PARTICIPANT, b"enclave=/;", b"")], [(PARTICIPANT, b"enclave=/;", LIST)]
    later = (2, *QUALITY[1:])
    graph = graph_of(
        (silent, [writer_on(b"rt/x")]),
        (listed, [writer_on(b"rt/x")]),
        (listed, [writer_on(b"rt/x")]),
        (listed, [writer_on(b"rt/x", later)]),
        (listed, []),
    )
    first, with_node, same, changed, gone = (graph._read(number).endpoints for number in range(5))
    assert [first[0].node, with_node[0].node] == [None, NodeName("/", "a")]
    assert same[0] is with_node[0]
    assert changed[0].qos.reliability is ReliabilityPolicy.BEST_EFFORT
    assert not gone


FAST, OTHER_FAST, FAST_END = (b"\x01\x0f" + bytes([number]) * 14 for number in (1, 2, 3))


@pytest.mark.parametrize(
    ("participant", "user_data", "ends", "has_list", "late"),
    [
        (FAST, b"enclave=/;", [], False, 1),
        (FAST, b"", [], False, 0),
        (FAST, b"enclave=/;", [], True, 0),
        (FAST, b"enclave=/;", [FAST_END], True, 1),
        (PARTICIPANT, b"enclave=/;", [], False, 0),
    ],
    ids=["no list", "no ROS", "a list", "an end is to come", "another vendor"],
)
def test_participants_of_fast_dds_are_late_until_their_lists_and_ends_arrive(
    participant: bytes, user_data: bytes, ends: list[bytes], has_list: bool, late: int
) -> None:
    told = discovery_info.encode(participant, [discovery_info.NodeEnds(NodeName("/", "a"), ends, [])])
    known = [(participant, user_data, told if has_list else b""), (OTHER_FAST, b"enclave=/;", NO_NODES)]
    graph = graph_of((known, []))
    assert len(graph._read(1).late) == late


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="datagrams are read on Linux alone")
@pytest.mark.parametrize("is_killed", [False, True])
@pytest.mark.usefixtures("short_lease")
def test_what_a_participant_announced_is_forgotten_when_it_leaves(
    participant, start_peer, wait_until, is_killed: bool
) -> None:
    """When it says so, and when its lease ends."""
    dds_read_versions()
    peer = start_peer()

    def remembered() -> list[bytes]:
        others = [info.gid for info in participant.graph.participants() if not info.is_own]
        return [gid for gid in others if dds_version(gid) and dds_knows_address(gid)]

    wait_until(lambda: len(remembered()) == 1, what="the peer's announcement")
    (gid,) = remembered()
    if is_killed:
        peer.program.process.kill()
    else:
        peer.program.process.stdin.close()
    wait_until(lambda: not dds_version(gid) and not dds_knows_address(gid), what="the peer's departure")
