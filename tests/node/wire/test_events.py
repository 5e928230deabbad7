"""Events of publishers and subscriptions that other processes cause."""

from __future__ import annotations

import json
import signal
import subprocess
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.conftest import Program, wait_until
from tests.node.wire.conftest import PROGRAMS

from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.context.context import Context
from tfloom.node.executing.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from tfloom.node.node import Node
from tfloom.node.qos.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSProfile,
    ReliabilityPolicy,
    qos_profile_best_available,
)
from tfloom.node.values.duration import Duration
from tfloom.rmw.events import Event, IncompatibleQoS
from tfloom.rmw.qos import QoSPolicyKind

SpinUntil = Callable[..., None]
StartTalker = Callable[..., "Talker"]

BEST_EFFORT = int(ReliabilityPolicy.BEST_EFFORT)
TRANSIENT_LOCAL = int(DurabilityPolicy.TRANSIENT_LOCAL)
MANUAL = int(LivelinessPolicy.MANUAL_BY_TOPIC)


class Talker:
    """A publisher in another process."""

    def __init__(self, program: Program, qos: dict[str, Any]) -> None:
        self.program = program
        self._earlier = len(program.lines)
        self.tell(json.dumps(qos))

    def tell(self, word: object) -> None:
        """Give a command to the process, and wait until it has followed it."""
        done = f"did {word}"
        count = self.lines.count(done)
        self.program.process.stdin.write(f"{word}\n")
        self.program.process.stdin.flush()
        wait_until(lambda: self.lines.count(done) > count, what=done)

    @property
    def lines(self) -> list[str]:
        return self.program.lines[self._earlier :]

    def told(self, event: str) -> list[dict[str, int]]:
        """Return the statuses of one event that the process has printed."""
        lines = [json.loads(line) for line in self.lines if line.startswith("[")]
        return [status for name, status in lines if name == event]


def start_program_of_talkers(start: Callable[..., Program]) -> Program:
    program = start("python", PROGRAMS / "talker.py", stdin=subprocess.PIPE)
    program.wait_for("ready")
    return program


@pytest.fixture(autouse=True)
def local_wire(wire_of_module: str) -> str:
    return wire_of_module


@pytest.fixture
def domain_id(module_domain_id: int, start_program: Callable[..., Program]) -> int:
    """Return the module's domain. The test's node ends before its programs; see `domain_id` of tests/conftest.py."""
    return module_domain_id


@pytest.fixture(scope="module")
def shared_program(wire_of_module: str, start_module_program: Callable[..., Program]) -> Iterator[Program]:
    program = start_program_of_talkers(start_module_program)
    yield program
    program.end()


@pytest.fixture
def start_talker(shared_program: Program) -> Iterator[StartTalker]:
    """Start a talker with a QoS, in a process that the tests share; it leaves with the test."""
    talkers: list[Talker] = []

    def start(**qos: Any) -> Talker:
        talkers.append(Talker(shared_program, qos))
        return talkers[-1]

    yield start
    for talker in talkers:
        talker.tell("leave")


def test_matched_events_count_peers(
    node: Node, start_talker: StartTalker, start_program: Callable[..., Program], spin_until: SpinUntil
) -> None:
    seen: list[Any] = []
    subscription = node.create_subscription(
        String, "chatter", print, 10, event_callbacks=SubscriptionEventCallbacks(matched=seen.append)
    )
    first, second = Talker(start_program_of_talkers(start_program), {}), start_talker()
    spin_until(lambda: seen and seen[-1].current_count == 2)
    assert seen[-1].total_count == 2
    first.tell("leave")
    spin_until(lambda: seen[-1].current_count == 1)
    assert (seen[-1].total_count, seen[-1].total_count_change, seen[-1].current_count_change) == (2, 0, -1)
    spin_until(lambda: second.told("matched"))
    node.destroy_subscription(subscription)
    spin_until(lambda: [event["current_count"] for event in second.told("matched")][-1:] == [0])
    begun, *_, last = second.told("matched")
    one = {"total_count": 1, "total_count_change": 1, "current_count": 1, "current_count_change": 1}
    assert begun == one
    assert last == {"total_count": 1, "total_count_change": 0, "current_count": 0, "current_count_change": -1}


def test_missed_deadline_is_reported_to_both_endpoints(
    node: Node, start_talker: StartTalker, spin_until: SpinUntil
) -> None:
    seen: list[Any] = []
    talker = start_talker(deadline=0.1)
    node.create_subscription(
        String,
        "chatter",
        lambda message: None,
        QoSProfile(depth=10, deadline=Duration(seconds=0.2)),
        event_callbacks=SubscriptionEventCallbacks(deadline=seen.append),
    )
    spin_until(lambda: talker.told("matched"))
    talker.tell(1)
    spin_until(lambda: len(seen) >= 2 and len(talker.told("deadline")) >= 2)
    totals = [status.total_count for status in seen]
    assert totals == sorted(totals)
    assert all(status.total_count_change >= 1 for status in seen)
    assert talker.told("deadline")[0]["total_count"] >= 1


def test_manual_liveliness_is_lost_and_regained(
    node: Node, start_talker: StartTalker, spin_until: SpinUntil
) -> None:
    seen: list[Any] = []
    talker = start_talker(liveliness=MANUAL, liveliness_lease_duration=0.4)
    qos = QoSProfile(
        depth=10, liveliness=LivelinessPolicy(MANUAL), liveliness_lease_duration=Duration(seconds=0.5)
    )
    callbacks = SubscriptionEventCallbacks(liveliness=seen.append)
    node.create_subscription(String, "chatter", lambda message: None, qos, event_callbacks=callbacks)
    spin_until(lambda: talker.told("matched"))
    for _ in range(2):
        talker.tell(1)
        spin_until(lambda: seen and (seen[-1].alive_count, seen[-1].not_alive_count) == (1, 0))
        spin_until(lambda: (seen[-1].alive_count, seen[-1].not_alive_count) == (0, 1))
        assert seen[-1].not_alive_count_change == 1
    spin_until(lambda: talker.told("liveliness"))
    assert talker.told("liveliness")[0]["total_count"] >= 1
    talker.tell("assert")


def test_killed_publisher_is_not_alive_after_its_lease(
    node: Node, start_program: Callable[..., Program], spin_until: SpinUntil
) -> None:
    seen: list[Any] = []
    program = start_program_of_talkers(start_program)
    Talker(program, {"liveliness_lease_duration": 0.5})
    qos = QoSProfile(depth=10, liveliness_lease_duration=Duration(seconds=0.5))
    callbacks = SubscriptionEventCallbacks(liveliness=seen.append)
    node.create_subscription(String, "chatter", print, qos, event_callbacks=callbacks)
    spin_until(lambda: seen and seen[-1].alive_count == 1)
    program.signal(signal.SIGKILL)
    spin_until(lambda: seen[-1].alive_count == 0)
    assert seen[-1] == (0, 1, -1, 1)


@pytest.mark.parametrize(
    ("offered", "requested", "kind", "sides"),
    [
        (
            {"reliability": ReliabilityPolicy.BEST_EFFORT},
            {},
            QoSPolicyKind.RELIABILITY,
            "offered RELIABILITY BEST_EFFORT, requested RELIABILITY RELIABLE",
        ),
        (
            {},
            {"durability": DurabilityPolicy.TRANSIENT_LOCAL},
            QoSPolicyKind.DURABILITY,
            "offered DURABILITY VOLATILE, requested DURABILITY TRANSIENT_LOCAL",
        ),
        (
            {},
            {"deadline": Duration(seconds=1)},
            QoSPolicyKind.DEADLINE,
            "offered no DEADLINE, requested DEADLINE of 1 s",
        ),
        (
            {"liveliness_lease_duration": Duration(seconds=2)},
            {"liveliness_lease_duration": Duration(seconds=0.5)},
            QoSPolicyKind.LIVELINESS,
            (
                "offered LIVELINESS AUTOMATIC with a lease of 2 s, "
                "requested LIVELINESS AUTOMATIC with a lease of 0.5 s"
            ),
        ),
        (
            {},
            {"liveliness": LivelinessPolicy.MANUAL_BY_TOPIC},
            QoSPolicyKind.LIVELINESS,
            "offered LIVELINESS AUTOMATIC, requested LIVELINESS MANUAL_BY_TOPIC",
        ),
    ],
)
def test_incompatible_qos_is_reported_on_both_sides_with_both_policies(
    node: Node,
    spin_until: SpinUntil,
    capsys: pytest.CaptureFixture[str],
    offered: dict[str, Any],
    requested: dict[str, Any],
    kind: QoSPolicyKind,
    sides: str,
    local_wire: str,
) -> None:
    heard: list[String] = []
    with Context() as elsewhere, Node("teller", context=elsewhere) as talker:
        publisher = talker.create_publisher(String, "chatter", QoSProfile(depth=10, **offered))
        assert node.wait_for_node("/teller", timeout=20)
        node.create_subscription(String, "chatter", heard.append, QoSProfile(depth=10, **requested))
        text = ""

        def warned() -> bool:
            nonlocal text
            text += capsys.readouterr().err
            return "Last incompatible policy" in text

        spin_until(warned)
        assert f"Last incompatible policy: {kind.name} ({sides}, peer /teller)" in text
        assert "New publisher discovered on topic '/chatter', offering incompatible QoS" in text
        told: list[Any] = []
        spin_until(
            lambda: told.append(publisher.wire_endpoint.take_event(Event.INCOMPATIBLE_QOS)) or told[-1]
        )
        assert told[-1] == IncompatibleQoS(1, 1, kind)
        ticks: list[None] = []
        publisher.publish(String())
        node.create_timer(0.01, lambda: ticks.append(None))
        spin_until(lambda: len(ticks) > 2)
        if local_wire == "rmw_zenoh_cpp":  # which passes it on, as rmw_zenoh does, and the warning says so
            assert "Messages pass all the same on this wire, but don't on others" in text
            spin_until(lambda: heard)
        else:
            assert "No messages will be received from it" in text
            assert not heard


def test_expired_messages_are_not_delivered_to_late_subscriptions(
    node: Node, start_talker: StartTalker, spin_until: SpinUntil
) -> None:
    talker = start_talker(durability=TRANSIENT_LOCAL, lifespan=0.5)
    heard: list[str] = []
    talker.tell(3)
    end = node.get_clock().now() + Duration(seconds=0.6)
    spin_until(lambda: node.get_clock().now() > end)
    late = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_subscription(String, "chatter", lambda message: heard.append(message.data), late)
    spin_until(lambda: talker.told("matched"))
    talker.tell(4)
    spin_until(lambda: len(heard) >= 4)
    assert heard == ["0", "1", "2", "3"]


def test_all_events_can_be_handled_at_once(
    node: Node, start_talker: StartTalker, spin_until: SpinUntil
) -> None:
    seen: list[str] = []
    heard: list[String] = []

    def watch(name: str) -> Callable[[Any], None]:
        return lambda status: seen.append(name)

    fields = ("deadline", "incompatible_qos", "liveliness", "message_lost", "matched")
    callbacks = SubscriptionEventCallbacks(**{name: watch(name) for name in fields})
    subscription = node.create_subscription(String, "chatter", heard.append, 10, event_callbacks=callbacks)
    assert len(subscription.event_handlers) == len(fields) + 1  # and that of incompatible types
    talker = start_talker()
    spin_until(lambda: talker.told("matched"))
    talker.tell(2)
    spin_until(lambda: len(heard) == 2)
    assert set(seen) == {"matched", "liveliness"}


def test_best_available_matches_the_talkers(
    node: Node, start_talker: StartTalker, spin_until: SpinUntil
) -> None:
    start_talker(reliability=BEST_EFFORT, durability=TRANSIENT_LOCAL)
    assert node.wait_for_node("/talker", timeout=20)
    spin_until(lambda: node.count_publishers("chatter"))
    seen: list[Any] = []
    callbacks = SubscriptionEventCallbacks(matched=seen.append)
    node.create_subscription(String, "chatter", print, qos_profile_best_available, event_callbacks=callbacks)
    spin_until(lambda: seen)
    (info,) = node.get_subscriptions_info_by_topic("chatter")
    assert info.qos_profile.reliability is ReliabilityPolicy.BEST_EFFORT
    assert info.qos_profile.durability is DurabilityPolicy.TRANSIENT_LOCAL
    publisher = node.create_publisher(
        String, "other", qos_profile_best_available, event_callbacks=PublisherEventCallbacks()
    )
    (info,) = node.get_publishers_info_by_topic("other")
    assert publisher.topic_name == "/other"
    assert info.qos_profile.reliability is ReliabilityPolicy.RELIABLE
    assert info.qos_profile.history is HistoryPolicy.KEEP_LAST
