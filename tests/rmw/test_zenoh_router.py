"""The router of the Zenoh wire as a program: it starts, names who holds its port, and ends on a signal."""

from __future__ import annotations

import signal
import socket
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import Program, wait_until
from tests.zenoh_ports import hold_zenoh_port

from tfloom.cli.main import main
from tfloom.rmw.zenoh import meeting_point as zenoh_meeting_point
from tfloom.rmw.zenoh.config import (
    default_configuration,
    router_configuration,
    router_settings,
    session_configuration,
)
from tfloom.rmw.zenoh.links import unlinked_endpoints
from tfloom.rmw.zenoh.meeting_point import LINK_GAP_S, MeetingPoint, open_lone_router
from tfloom.rmw.zenoh.router import open_router, open_where_free
from tfloom.rmw.zenoh.session import open_session

zenoh = pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")


ROUTERS = {
    "verb": ("tfloom", "zenoh", "router"),
    "program": ("tfloom", "run", "rmw_zenoh_cpp", "rmw_zenohd", "--ros-args", "-r", "__node:=router"),
}


@pytest.fixture(autouse=True)
def port(start_program: Callable[..., Program]) -> Iterator[int]:
    with hold_zenoh_port() as held:
        yield held


@pytest.mark.parametrize("name", ROUTERS)
def test_router_links_sessions_and_ends_on_ctrl_c(
    name: str, port: int, start_program: Callable[..., Program]
) -> None:
    router = start_program(*ROUTERS[name])
    router.wait_for(f"listening on tcp/127.0.0.1:{port}")
    zid = router.lines[-1].split("id ")[1].split(",")[0]
    with zenoh.open(session_configuration()) as session:
        wait_until(lambda: [str(router_zid) for router_zid in session.info.routers_zid()] == [zid])
        router.signal(signal.SIGINT)
        assert router.wait() == 0
        assert router.lines[-1] == "Zenoh router ends"
        wait_until(lambda: not session.info.routers_zid())


def test_sigterm_ends_the_router(start_program: Callable[..., Program]) -> None:
    router = start_program("tfloom", "zenoh", "router")
    router.wait_for("listening on")
    router.signal(signal.SIGTERM)
    assert router.wait() == 128 + signal.SIGTERM
    assert len(router.lines) == 1


def test_second_router_names_the_first(port: int, start_program: Callable[..., Program]) -> None:
    first = start_program("tfloom", "zenoh", "router")
    first.wait_for("listening on")
    second = start_program("tfloom", "zenoh", "router")
    assert second.wait() == 1
    assert len(second.lines) == 1
    assert second.lines[0].startswith(
        f"the router can't listen on tcp/127.0.0.1:{port}: the port is held by "
    )
    if sys.platform == "linux":
        assert f"process {first.process.pid} (" in second.output
        assert "stopped" not in second.output
        first.pause()
        third = start_program("tfloom", "run", "rmw_zenoh_cpp", "rmw_zenohd")
        assert third.wait() == 1
        assert f"process {first.process.pid} (" in third.output
        assert "which is stopped (Ctrl-Z, a debugger?)" in third.output


def test_routers_are_joined(port: int, start_program: Callable[..., Program]) -> None:
    start_program("tfloom", "zenoh", "router").wait_for("listening on")
    words = ("-l", "tcp/127.0.0.1:0", "-e", f"tcp/127.0.0.1:{port}")
    start_program("tfloom", "zenoh", "router", *words).wait_for(f"linked to tcp/127.0.0.1:{port}")
    with zenoh.open(session_configuration()) as session:
        # The session is linked to the first alone, which knows the second by the routers' own protocol.
        wait_until(lambda: len(session.info.routers_zid()) == 1)


def test_a_router_says_why_it_is_not_linked_to_another_and_when_it_is(
    port: int, start_program: Callable[..., Program]
) -> None:
    other = f"tcp/127.0.0.1:{port + 1}"
    router = start_program("tfloom", "zenoh", "router", "-e", other)
    why = f"no link to {other} yet, which refuses: nothing listens there. It is sought again"
    router.wait_for(why)
    words = "tfloom", "zenoh", "router", "-l", other
    neighbour = start_program(*words)
    wait_until(lambda: f"linked to {other}" in router.lines)
    neighbour.signal(signal.SIGKILL)
    wait_until(lambda: router.lines.count(why) == 2)
    start_program(*words).wait_for("listening on")
    wait_until(lambda: router.lines.count(f"linked to {other}") == 2)
    assert router.lines.count(why) == 2


def test_endpoints_without_a_link(port: int) -> None:
    """A host's name stands for its addresses; of two routers that connect to each other, one makes the link of both."""
    elsewhere = "tcp/127.0.0.2:1"
    first = router_configuration({"connect/endpoints": [f"tcp/localhost:{port + 1}", elsewhere]})
    second = router_configuration(
        {"listen/endpoints": [f"tcp/127.0.0.1:{port + 1}"], "connect/endpoints": [f"tcp/127.0.0.1:{port}"]}
    )
    with open_router(first) as here:
        assert len(unlinked_endpoints(here, first)) == 2
        with open_router(second) as there:
            wait_until(lambda: unlinked_endpoints(here, first) == [elsewhere])
            wait_until(lambda: unlinked_endpoints(there, second) == [])


def test_wrong_arguments_are_one_line(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "router.json5"
    file.write_text('{mode: "peer"}')
    for words, printed in (
        (("-l", "nonsense"), 'Zenoh refuses listen/endpoints=["nonsense"]: Endpoints must be of the form'),
        (("-l", "tcp/192.0.2.1:7447"), "the router can't listen on tcp/192.0.2.1:7447: Can not create a"),
        (("-c", "/no/such.json5"), "names /no/such.json5, which can't be read: No such file or directory"),
        (("-c", str(file)), 'the configuration has the mode "peer", a router needs "router"\n'),
    ):
        assert main(["zenoh", "router", *words]) == 1
        said = "".join(capfd.readouterr())
        assert printed in said
        assert said.count("\n") == 1, said


TOKEN = "test/neighbours/token"


@pytest.fixture
def neighbour() -> Iterator[str]:
    """Open the router of another machine, with a token at it; return its endpoint."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        endpoint = f"tcp/127.0.0.1:{free.getsockname()[1]}"
    settings = router_settings()
    router = default_configuration({**settings, "listen/endpoints": [endpoint]})
    client = {**settings, "mode": "client", "listen/endpoints": [], "connect/endpoints": [endpoint]}
    with closing(open_router(router)), zenoh.open(default_configuration(client)) as session:
        token = session.liveliness().declare_token(TOKEN)
        yield endpoint
        token.undeclare()


def linked_to(endpoint: str) -> Any:
    """Return the configuration of this machine's router that connects to another one."""
    return default_configuration({**router_settings(), "connect/endpoints": [endpoint]})


def wait_for_token(router: Any) -> None:
    """Wait until the neighbour's token has come to a router."""
    tokens: list[str] = []
    subscriber = router.liveliness().declare_subscriber(
        "test/**", lambda sample: tokens.append(str(sample.key_expr)), history=True
    )
    wait_until(lambda: tokens == [TOKEN])
    subscriber.undeclare()


def test_a_router_that_restarts_at_once_hears_of_its_neighbours_tokens(neighbour: str) -> None:
    for _ in range(3):
        with closing(open_lone_router(linked_to(neighbour))) as router:
            # Ended as soon as the token is here, because the neighbour looks at its routers again a while after that.
            wait_for_token(router)


@pytest.fixture
def opened_s(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Return a list that gets the time at which each router of this machine is opened [s]."""
    times: list[float] = []

    def open_and_note(config: Any) -> Any:
        now_s = time.monotonic()
        router = open_where_free(config)
        if router is not None:
            times.append(now_s)
        return router

    monkeypatch.setattr(zenoh_meeting_point, "open_where_free", open_and_note)
    return times


def test_a_session_takes_over_a_linked_router_after_a_gap(
    neighbour: str, opened_s: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_STATIC_PEERS", neighbour)
    with closing(open_session()) as owner, closing(open_session()) as other:
        assert other.wait_for_router(10.0)
        owner.close()
        closed_s = time.monotonic()
        wait_until(lambda: len(opened_s) == 2)
        assert opened_s[1] - closed_s >= LINK_GAP_S


def test_a_linked_router_takes_a_sessions_place_after_a_gap(
    neighbour: str, opened_s: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    closed_s: list[float] = []
    close_router = MeetingPoint._close_router

    def close_and_note(meeting_point: MeetingPoint) -> None:
        is_open = meeting_point.is_owner
        close_router(meeting_point)
        if is_open:
            closed_s.append(time.monotonic())

    monkeypatch.setattr(MeetingPoint, "_close_router", close_and_note)
    monkeypatch.setenv("ROS_STATIC_PEERS", neighbour)
    with closing(open_session()) as owner:
        assert owner.wait_for_router(10.0)
        with closing(open_lone_router(linked_to(neighbour))):
            # The port is free a little before the session's router has ended.
            assert len(closed_s) == 1
            assert opened_s[1] - closed_s[0] >= LINK_GAP_S - 0.1
