"""Services, actions and parameters between tfloom and Fast DDS, each in its form: `native/rtps/service_forms.hpp`.

A direction names the client's vendor first.
"""

from __future__ import annotations

import os
import signal
from collections.abc import Callable
from itertools import count
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from tests.bag.test_played_goals import cancellation, event, goal, result
from tests.bag.test_played_goals import write as write_goals
from tests.conftest import Program
from tools.ros_peer import KILTED, RosPeer

from .conftest import FROM_US, HERE, OURS, THEIRS, TO_US, End, starter, vendors

pytestmark = pytest.mark.ros

SERVICE_END = HERE / "programs" / "service_end.py"
SUCCEEDED, CANCELED = 4, 5
FIBONACCI = [0, 1, 1, 2, 3, 5, 8, 13]
MEGABYTE = 1_000_000


class Sides(NamedTuple):
    """A client's end and a server's end."""

    client: End
    server: End


@pytest.fixture
def start_side(peer: RosPeer, domain_id: int, start_program: Callable[..., Program]) -> Callable[..., End]:
    """Return a function that starts an end with services: `start_side(THEIRS, "server")`."""
    if not peer.has("example_interfaces"):
        pytest.skip("example_interfaces is not compiled for the real rclpy: `make ros-peer` says why")
    return starter(peer, domain_id, start_program, SERVICE_END)


@pytest.fixture
def sides(start_side: Callable[..., End], direction: str) -> Sides:
    """Return new ends, as the client's and the server's."""
    client, server = vendors(direction)
    return Sides(start_side(client, "the_client"), start_side(server, "the_server"))


def kill(end: End) -> None:
    os.kill(end.program.process.pid, signal.SIGKILL)
    end.program.wait()


def assert_all_answered(answers: dict[str, Any], number: int, offset: int = 0) -> None:
    assert answers["lost"] == []
    assert answers["offsets"] == [[offset, number]]


@pytest.mark.row("services")
def test_all_sequential_calls_are_answered_once(sides: Sides) -> None:
    sides.server("add_server", "/add")
    sides.client("clients", "/add", 1)
    assert_all_answered(sides.client("call", "/add", 10_000), 10_000)
    assert sides.server("requests") == [10_000, 0]


@pytest.mark.row("services")
def test_all_of_many_calls_at_once_are_answered_once(sides: Sides, direction: str) -> None:
    # A stock client keeps ten responses until it takes them, and loses others, those of a stock server too.
    at_once = 200 if direction == FROM_US else 10
    sides.server("add_server", "/add")
    sides.client("clients", "/add", 1)
    for turn in range(5):
        assert_all_answered(sides.client("call", "/add", 200, at_once, 200 * turn), 200)
    assert sides.server("requests") == [1000, 0]


@pytest.mark.row("services")
def test_all_of_50_clients_are_answered(sides: Sides, direction: str) -> None:
    sides.server("add_server", "/add")
    sides.client("clients", "/add", 50)
    assert_all_answered(sides.client("call", "/add", 4, 50 if direction == FROM_US else 10), 200)
    assert sides.server("requests") == [200, 0]


@pytest.mark.row("services")
def test_first_call_of_each_new_client_is_answered(start_side: Callable[..., End], direction: str) -> None:
    client_vendor, server_vendor = vendors(direction)
    server = start_side(server_vendor, "the_server")
    server("add_server", "/add")
    for turn in range(8):
        client = start_side(client_vendor, f"client_{turn}")
        client("clients", "/add", 1)
        answers = client("call", "/add", 3, 1, 3 * turn)
        assert_all_answered(answers, 3)
        assert answers["slowest_s"] < 2.0  # less than the 3 s after which Fast DDS sends again by itself
        client.program.process.stdin.close()
        client.program.wait()


@pytest.mark.row("services")
@pytest.mark.parametrize("size", [60_000, 65_000, 65_016, MEGABYTE])
def test_large_answers_arrive_whole(sides: Sides, size: int) -> None:
    sides.server("text_server", "/text", size)
    sides.client("clients", "/text", 1, "text")
    assert sides.client("call_text", "/text", 10) == [size] * 10


@pytest.mark.row("services")
def test_servers_of_both_vendors_answer_under_one_name(
    start_side: Callable[..., End], direction: str, wait_until: Callable[..., None]
) -> None:
    client_vendor, _ = vendors(direction)
    offsets = {OURS: 1_000_000, THEIRS: 2_000_000}
    servers = {vendor: start_side(vendor, f"server_of_{vendor.split()[0]}") for vendor in offsets}
    for vendor, server in servers.items():
        server("add_server", "/add", offsets[vendor])
    client = start_side(client_vendor, "the_client")
    client("clients", "/add", 1)
    numbers = count(start=0, step=10)

    def both_serve() -> bool:
        assert client("call", "/add", 10, 1, next(numbers))["lost"] == []
        return all(server("requests")[0] > 0 for server in servers.values())

    wait_until(both_serve, 20.0, "both servers")
    # The client takes whichever answer is first. A stock server that is slower than the other keeps the last ten alone.
    answers = client("call", "/add", 200, 1, 100_000)
    assert answers["lost"] == []
    assert {offset for offset, _ in answers["offsets"]} <= set(offsets.values())
    assert sum(answered for _, answered in answers["offsets"]) == 200
    wait_until(lambda: servers[OURS]("requests", 100_000) == [200, 0], 10.0, "each request")
    served, twice = servers[THEIRS]("requests", 100_000)
    assert served > 0
    assert twice == 0


@pytest.mark.row("services")
def test_clients_of_both_vendors_are_answered_by_one_server(
    start_side: Callable[..., End], direction: str
) -> None:
    _, server_vendor = vendors(direction)
    server = start_side(server_vendor, "the_server")
    server("add_server", "/add", 7)
    clients = [start_side(vendor, f"client_of_{vendor.split()[0]}") for vendor in (OURS, THEIRS)]
    for client in clients:
        client("clients", "/add", 3)
    for turn in range(3):
        for number, client in enumerate(clients):
            base = 10_000 * number + 300 * turn
            assert_all_answered(client("call", "/add", 100, 10, base), 300, 7)
    assert server("requests") == [1800, 0]


@pytest.mark.row("services", direction=TO_US)
def test_responses_to_others_replace_none_in_a_stock_client(
    start_side: Callable[..., End], wait_until: Callable[..., None]
) -> None:
    # The readers of stock clients keep ten samples: the responses to others would replace the one that is awaited.
    server = start_side(OURS, "the_server")
    server("add_server", "/add")
    slow, other = start_side(THEIRS, "slow_client"), start_side(THEIRS, "other_client")
    for client in (slow, other):
        client("clients", "/add", 1)
        assert client("call", "/add", 1)["lost"] == []
    slow("occupy")
    slow("call_occupied", "/add")
    wait_until(lambda: server("requests")[0] == 2, 20.0, "the request of the slow client")
    assert_all_answered(other("call", "/add", 50, 1, 1000), 50)
    assert slow("free", 5.0)


@pytest.mark.row("services")
def test_server_that_was_killed_answers_when_it_returns(
    start_side: Callable[..., End], direction: str, wait_until: Callable[..., None]
) -> None:
    client_vendor, server_vendor = vendors(direction)
    client = start_side(client_vendor, "the_client")
    for turn in range(3):
        server = start_side(server_vendor, f"server_{turn}", TFLOOM_LEASE_S="2")
        server("add_server", "/add", turn)
        if turn == 0:
            client("clients", "/add", 1)
        wait_until(lambda: client("call_or_error", "/add", 1.0) == "answered", 30.0, "an answer")
        answers = client("call", "/add", 20, 1, 100 * turn)
        assert answers["lost"] == []
        kill(server)


@pytest.mark.row("actions")
def test_goals_succeed_and_are_canceled(sides: Sides) -> None:
    sides.server("action_server", "/count")
    sides.client("action_client", "/count")
    for _ in range(3):
        done = sides.client("send_goal", "/count", len(FIBONACCI))
        assert done["status"] == SUCCEEDED
        assert done["sequence"] == FIBONACCI
        assert done["feedback"] == list(range(3, len(FIBONACCI) + 1))
    stopped = sides.client("send_goal", "/count", 40, True)
    assert stopped["status"] == CANCELED
    assert stopped["canceling"] == 1
    assert len(stopped["sequence"]) < 40


def recorded_goals(folder: Path, order: int) -> Path:
    """Write a bag with the events of a server: a goal whose result is asked for, and one that is cancelled."""
    return write_goals(
        folder,
        event(0, goal(order)),
        event(1, result(order)),
        event(1000, goal(100)),
        event(1300, cancellation(100)),
    )


@pytest.mark.row("actions", direction=FROM_US)
def test_recorded_goals_reach_a_server(
    start_side: Callable[..., End],
    start_program: Callable[..., Program],
    tmp_path: Path,
    wait_until: Callable[..., None],
) -> None:
    server = start_side(THEIRS, "the_server")
    server("action_server", "/fibonacci")
    bag = recorded_goals(tmp_path / "bag", len(FIBONACCI))
    play = start_program("tfloom", "bag", "play", str(bag), "--send-actions-as-client")
    assert play.wait() == 0
    both = [[len(FIBONACCI), "succeeded"], [100, "canceled"]]
    wait_until(lambda: server("ended") == both, what="the ends of both goals")
    assert "left out" not in play.output


@pytest.mark.row("actions", direction=FROM_US)
@pytest.mark.parametrize("peer", [KILTED], indirect=True, scope="session", ids=["kilted"])
def test_goals_that_a_server_has_recorded_are_sent_again(
    start_side: Callable[..., End],
    start_program: Callable[..., Program],
    tmp_path: Path,
    wait_until: Callable[..., None],
) -> None:
    """The events are those of the real rclpy, which has them from Kilted on."""
    server, client = start_side(THEIRS, "the_server"), start_side(THEIRS, "the_client")
    server("action_server", "/fibonacci")
    server("introspect", "/fibonacci")
    client("action_client", "/fibonacci")
    record = start_program("tfloom", "bag", "record", "-o", str(tmp_path / "bag"), "--actions", "/fibonacci")
    for service in ("send_goal", "cancel_goal", "get_result"):
        record.wait_for(f"Subscribed to topic '/fibonacci/_action/{service}/_service_event'")
    assert client("send_goal", "/fibonacci", len(FIBONACCI))["status"] == SUCCEEDED
    assert client("send_goal", "/fibonacci", 100, True)["status"] == CANCELED
    both = [[len(FIBONACCI), "succeeded"], [100, "canceled"]]
    assert server("ended") == both
    record.signal(signal.SIGINT)
    assert record.wait() == 0
    play = start_program("tfloom", "bag", "play", str(tmp_path / "bag"), "--send-actions-as-client")
    assert play.wait() == 0
    wait_until(
        lambda: sorted(server("ended")) == sorted(both * 2), what="the ends of the goals that were sent again"
    )


@pytest.mark.row("parameters")
def test_parameters_are_set_and_read(sides: Sides) -> None:
    sides.server("declare", "speed", 1)
    for value in (2, 3, 4):
        assert sides.client("set_and_get", "the_server", "speed", value) == [True, value]
        assert sides.server("parameter", "speed") == value
