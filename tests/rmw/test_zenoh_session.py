"""Sessions of the Zenoh wire: where they meet with no router, who takes over, how they end."""

from __future__ import annotations

import os
import random
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from tests.conftest import Program, run_to_end, wait_until
from tests.rmw.conftest import ask, outputs_by_end, tell
from tests.zenoh_ports import hold_zenoh_port

from tfloom.cli.doctor import checks as health
from tfloom.cli.doctor.checks import check_round_trip
from tfloom.cli.doctor.finding import Verdict
from tfloom.cli.doctor.zenoh import check_router
from tfloom.rmw.errors import ClosedError, ConfigurationError, WireError
from tfloom.rmw.zenoh import meeting_point as zenoh_meeting_point
from tfloom.rmw.zenoh import router as zenoh_router
from tfloom.rmw.zenoh import session as zenoh_session
from tfloom.rmw.zenoh.config import meeting_point_configuration, router_configuration, session_configuration
from tfloom.rmw.zenoh.meeting_point import MeetingPoint
from tfloom.rmw.zenoh.port_holder import end_connections
from tfloom.rmw.zenoh.session import ZenohSession, open_session

zenoh = pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")

needs_fork = pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
MEMBER = Path(__file__).parent / "programs" / "zenoh_member.py"
STOCK = """{
  // What a stock node has: rmw_zenoh's defaults, which seek a router and gossip to routers alone.
  mode: "peer", connect: {endpoints: ["tcp/localhost:%d"], timeout_ms: -1, exit_on_failure: false,
    retry: {period_init_ms: 1000, period_max_ms: 4000, period_increase_factor: 2}},
  listen: {endpoints: ["tcp/localhost:0"]},
  scouting: {multicast: {enabled: false}, gossip: {enabled: true, multihop: false,
    target: {router: ["router", "peer"], peer: ["router"]}, autoconnect: {router: [], peer: ["router", "peer"]},
    autoconnect_strategy: {peer: {to_router: "always", to_peer: "greater-zid"}}}},
  timestamping: {enabled: {router: true, peer: true, client: true}},
}"""


@pytest.fixture(autouse=True)
def port(start_program: Callable[..., Program]) -> Iterator[int]:
    with hold_zenoh_port() as held:
        yield held


@pytest.fixture
def start(start_program: Callable[..., Program]) -> Callable[..., Program]:
    """Start a member by its name, and wait until its session is open."""

    def start_member(name: str, *commands: str, wait: bool = True) -> Program:
        program = start_program(sys.executable, MEMBER, name, *commands, stdin=subprocess.PIPE)
        if wait:
            program.wait_for("open ")
        return program

    return start_member


def sees(program: Program, *names: str) -> bool:
    """Return whether a member's graph holds these names, in order of the alphabet."""
    graphs = [line for line in program.lines if line.startswith("sees ")]
    return bool(graphs) and graphs[-1] == f"sees {' '.join(names)}"


def wait_for(condition: Callable[[], object], *members: Program) -> None:
    """Wait for a condition; fail with what the members have printed."""
    try:
        wait_until(condition)
    except pytest.fail.Exception:
        pytest.fail("\n\n".join("\n".join(member.lines[-30:]) for member in members))


def is_owner(program: Program) -> bool:
    return ask(program, "owner")[1] == "True"


def test_programs_meet_without_a_router(start: Callable[..., Program]) -> None:
    members = {name: start(name) for name in ("a", "b", "c")}
    assert "open owner" in members["a"].output
    assert "open guest" in members["b"].output
    for member in members.values():
        wait_until(lambda member=member: sees(member, "a", "b", "c"))


def test_of_programs_that_start_together_one_is_the_owner(start: Callable[..., Program]) -> None:
    members = {name: start(name, wait=False) for name in "abcde"}
    for member in members.values():
        wait_until(lambda member=member: sees(member, *"abcde"))
    assert sum("open owner" in member.output for member in members.values()) == 1
    assert not any("tfloom:" in member.output for member in members.values())


def test_a_session_that_finds_a_router_does_not_seek_who_holds_its_port(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for module in (zenoh_router, zenoh_meeting_point):
        monkeypatch.setattr(module, "find_port_owner", None)
    with closing(open_session()), closing(open_session()) as guest:
        assert not guest.is_meeting_point


@pytest.mark.skipif(sys.platform == "win32", reason="a process can't find its connections there")
def test_no_link_stays_that_is_made_while_the_router_closes(port: int) -> None:
    """The library leaves such a link open; it did so in one round of three to five."""
    delays = random.Random(7)
    for _ in range(25):
        point = MeetingPoint()
        assert point.is_owner
        guests: list[Any] = []

        def join(delay_s: float, guests: list[Any] = guests) -> None:
            time.sleep(delay_s)
            guests.append(zenoh.open(session_configuration()))

        threads = [threading.Thread(target=join, args=(delays.uniform(0.0, 0.02),)) for _ in range(4)]
        for thread in threads:
            thread.start()
        time.sleep(0.01)  # in the middle of when they come
        point.close()
        for thread in threads:
            thread.join()
        wait_until(
            lambda guests=guests: not any(guest.info.routers_zid() for guest in guests), 10.0, "the end"
        )
        for guest in guests:
            guest.close()


@pytest.mark.skipif(sys.platform == "win32", reason="a process can't find its connections there")
def test_only_connections_that_were_accepted_at_the_port_are_ended() -> None:
    with socket.create_server(("127.0.0.1", 0)) as listener, socket.create_server(("127.0.0.1", 0)) as other:
        ours, theirs = listener.getsockname()[1], other.getsockname()[1]
        with (
            socket.create_connection(("127.0.0.1", ours)) as client,
            socket.create_connection(("127.0.0.1", theirs)) as bystander,
            listener.accept()[0],
            other.accept()[0] as accepted,
        ):
            assert end_connections(ours) == 1
            client.settimeout(10.0)
            assert client.recv(1) == b""
            accepted.sendall(b"x")
            assert bystander.recv(1) == b"x"
        assert end_connections(ours) == 0
        with socket.create_connection(("127.0.0.1", ours)) as again, listener.accept()[0] as next_one:
            next_one.sendall(b"y")  # it listens as before
            assert again.recv(1) == b"y"


@pytest.mark.timing
@pytest.mark.parametrize("end", ["kill", "close"])
def test_another_takes_over_within_two_seconds(end: str, start: Callable[..., Program]) -> None:
    owner, first, second = start("owner"), start("first", "tick"), start("second")
    wait_until(lambda: sees(second, "first", "owner", "second") and sees(first, "first", "owner", "second"))
    wait_until(lambda: int(ask(second, "count", "first")[2]) > 10)
    ask(second, "forget")
    started = time.monotonic()
    if end == "kill":
        owner.signal(signal.SIGKILL)
    else:
        tell(owner, "close")
    late = start("late")
    members = first, second, late
    # A router that is closed may still serve for a moment, also the late program.
    wait_until(lambda: [is_owner(member) for member in members].count(True) == 1)
    wait_for(lambda: sees(late, "first", "late", "second"), *members)
    took_s = time.monotonic() - started
    wait_until(lambda: sees(first, "first", "late", "second"))
    assert (
        took_s < 2.0 + 1.0
    )  # with the start of the late program, whose interpreter and libraries take up to a second
    # The two had their own link: what flowed between them went on.
    assert float(ask(second, "count", "first")[3]) < 1.0


def test_a_stopped_owner_is_named(
    start: Callable[..., Program], port: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    owner = start("owner")
    owner.pause()
    late = start("late", wait=False)
    late.wait_for(f"no answer from the router on 127.0.0.1:{port}, held by ")
    if sys.platform == "linux":
        assert f"held by process {owner.process.pid} (" in late.output
        assert "which is stopped (Ctrl-Z, a debugger?)" in late.output
    late.wait_for("open guest")
    if sys.platform == "linux":
        finding = check_router()
        assert finding.verdict is Verdict.FAILED
        assert f"held by process {owner.process.pid} (" in finding.summary
        assert finding.advice == "end that process, or let it go on (fg, kill -CONT)"
        monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
        monkeypatch.setattr(health, "TRIP_TIMEOUT_S", 0.1)
        assert check_round_trip().advice == "see the row of the router"
    owner.signal(signal.SIGCONT)
    wait_until(lambda: sees(late, "late", "owner") and sees(owner, "late", "owner"))
    assert late.output.count("no answer") == 1


def test_a_stopped_owner_that_is_killed_is_replaced(start: Callable[..., Program]) -> None:
    owner = start("owner")
    owner.pause()
    late = start("late")
    owner.signal(signal.SIGKILL)
    wait_until(lambda: is_owner(late))
    newcomer = start("newcomer")
    wait_until(lambda: sees(newcomer, "late", "newcomer") and sees(late, "late", "newcomer"))


@pytest.mark.parametrize("routers", [[1], []], ids=["linked", "not linked"])
def test_session_that_can_not_be_closed_is_a_line(
    port: int, capfd: pytest.CaptureFixture[str], routers: list[int]
) -> None:
    """Zenoh gives up after ten seconds where the router takes nothing; all else ends as usual."""
    opened = open_session()
    session = opened.session

    class Unclosable:
        info = SimpleNamespace(routers_zid=lambda: routers)

        def close(self) -> None:
            session.close()
            raise zenoh.ZError("close operation timed out! at /somewhere/close.rs:135.")

    opened._session = Unclosable()
    opened.close()
    assert not opened.is_meeting_point
    line = (
        "tfloom: what was written last may be lost, because the Zenoh session can't be closed: "
        "close operation timed out!\n"
    )
    assert capfd.readouterr().err == line


def test_router_that_can_not_be_closed_is_a_line(port: int, capfd: pytest.CaptureFixture[str]) -> None:
    opened = open_session()
    meeting_point: Any = opened._meeting_point
    wait_until(lambda: meeting_point._router is not None, what="the router")
    router = meeting_point._router

    class Unclosable:
        def close(self) -> None:
            router.close()
            raise zenoh.ZError("close operation timed out! at /somewhere/close.rs:135.")

    meeting_point._router = Unclosable()
    opened.close()
    assert not opened.is_meeting_point
    line = "tfloom: the Zenoh router of this process can't be closed: close operation timed out!\n"
    assert capfd.readouterr().err == line
    opened.close()  # again


def test_wait_for_a_router_sleeps_between_its_looks(monkeypatch: pytest.MonkeyPatch) -> None:
    done: list[str] = []
    session = SimpleNamespace(info=SimpleNamespace(routers_zid=lambda: done.append("look")))

    def sleep(seconds: float) -> None:
        done.append("sleep")
        time.sleep(seconds)

    monkeypatch.setattr(zenoh_session, "time", SimpleNamespace(monotonic=time.monotonic, sleep=sleep))
    opened = ZenohSession(session, None, None)
    assert not opened.wait_for_router(0.05)
    opened._is_closed = True
    assert set(done[::2]) == {"look"}
    assert set(done[1::2]) == {"sleep"}


@pytest.mark.parametrize(("checks", "looks", "reports"), [(0, 0, 0), (1, 1, 1), (3, 3, 2)])
def test_router_that_is_sought_in_vain_is_told_at_the_first_look_and_at_the_last(
    checks: int, looks: int, reports: int
) -> None:
    done: list[str] = []
    opened: Any = SimpleNamespace(
        endpoints=["tcp/127.0.0.1:7447"], wait_for_router=lambda _: done.append("look")
    )
    meeting_point: Any = SimpleNamespace(report_silence=lambda: done.append("report"))
    zenoh_session._look_for_router(opened, meeting_point, checks)
    assert (done.count("look"), done.count("report")) == (looks, reports)
    assert done[:2] == ["look", "report"][: 2 * looks]


@pytest.mark.slow
def test_program_ends_without_a_traceback_while_the_router_is_stopped(
    start_program: Callable[..., Program], domain_id: int, port: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    owner = start_program("tfloom", "run", "demo_nodes_py", "talker")
    owner.wait_for("Publishing")
    owner.pause()
    listener = start_program("tfloom", "run", "demo_nodes_py", "listener")
    listener.wait_for("no answer from the router")
    listener.signal(signal.SIGINT)
    assert listener.wait() == 0
    assert "Traceback" not in listener.output
    assert "the Zenoh session can't be closed" not in listener.output  # as after a wait of ten seconds


def test_without_a_thread_a_session_that_is_not_linked_is_closed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF")
    opened = open_session()
    session = opened.session

    def refuse(thread: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(threading.Thread, "start", refuse)
    opened.close()
    assert session.is_closed()


def test_stock_nodes_meet_at_the_point(
    start: Callable[..., Program], port: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A stock node doesn't open a router; two that find ours discover each other, and our programs."""
    ours = start("ours")
    file = tmp_path / "stock.json5"
    file.write_text(STOCK % port)
    tokens: list[set[str]] = [set(), set()]
    stock = [zenoh.open(zenoh.Config.from_file(file)) for _ in tokens]
    try:
        kept = []
        for number, session in enumerate(stock):
            handler = zenoh.handlers.Callback(
                lambda sample, number=number: tokens[number].add(str(sample.key_expr).rpartition("/")[2]),
                indirect=False,
            )
            kept.append(session.liveliness().declare_subscriber("test/members/*", handler, history=True))
            kept.append(session.liveliness().declare_token(f"test/members/stock{number}"))
        wait_until(lambda: all(graph == {"ours", "stock0", "stock1"} for graph in tokens))
        wait_until(lambda: sees(ours, "ours", "stock0", "stock1"))
        # Of two programs of ours with the same file, one still opens the router that stock nodes lack.
        monkeypatch.setenv("ZENOH_SESSION_CONFIG_URI", str(file))
        guest = start("guest")
        wait_until(lambda: sees(guest, "guest", "ours", "stock0", "stock1"))
        ours.signal(signal.SIGKILL)
        wait_until(lambda: is_owner(guest))
    finally:
        for session in stock:
            session.close()


def test_a_router_of_its_own_is_used(
    start: Callable[..., Program], start_program: Callable[..., Program]
) -> None:
    start_program("tfloom", "zenoh", "router").wait_for("listening on")
    a, b = start("a"), start("b")
    wait_until(lambda: sees(a, "a", "b") and sees(b, "a", "b"))
    assert not is_owner(a)
    assert not is_owner(b)


def test_a_router_that_starts_later_takes_over(
    start: Callable[..., Program], start_program: Callable[..., Program]
) -> None:
    owner, guest = start("owner"), start("guest")
    wait_until(lambda: sees(owner, "guest", "owner") and sees(guest, "guest", "owner"))
    router = start_program("tfloom", "zenoh", "router")
    router.wait_for("listening on")
    late = start("late")
    for member in (owner, guest, late):
        wait_until(lambda member=member: sees(member, "guest", "late", "owner"))
        assert not is_owner(member)
        assert "no answer" not in member.output
    # It ends: a program takes over, and gives way again.
    router.signal(signal.SIGKILL)
    wait_until(lambda: any(is_owner(member) for member in (owner, guest, late)))
    start_program("tfloom", "zenoh", "router").wait_for("listening on")
    wait_until(lambda: not any(is_owner(member) for member in (owner, guest, late)))


def test_a_router_asks_again_where_no_session_is_linked_yet(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = threading.Semaphore(0)
    real_key = zenoh_meeting_point._give_way_key

    def key() -> str:
        asked.release()
        return real_key()

    def join() -> ZenohSession:
        """Open a session when the router asks for the second time, so the first one had no answer."""
        assert asked.acquire(timeout=5.0)
        assert asked.acquire(timeout=5.0)
        return open_session()

    monkeypatch.setattr(zenoh_meeting_point, "_give_way_key", key)
    with (
        zenoh_router.open_router(meeting_point_configuration()),
        ThreadPoolExecutor(1) as pool,
    ):
        joining = pool.submit(join)
        assert zenoh_meeting_point._ask_to_give_way()
        joining.result().close()


@pytest.mark.parametrize("deaf", ["owner", "guest"])
def test_a_router_asks_again_where_a_session_did_not_hear_it(
    monkeypatch: pytest.MonkeyPatch, deaf: str
) -> None:
    """After a change of owner, some sessions still search for its router, the owner's own too, and others answer."""
    hear = MeetingPoint._on_request
    asked: list[MeetingPoint] = []

    def hear_the_second(point: MeetingPoint, query: Any) -> None:
        is_deaf = point is sessions[deaf]._meeting_point and point not in asked
        asked.append(point)
        query.drop() if is_deaf else hear(point, query)

    def await_free_port() -> None:
        if deaf == "guest" and len(asked) == len(sessions):
            wait_until(lambda: sessions["guest"].is_meeting_point)
        await_port()

    await_port = zenoh_meeting_point._await_free_port
    monkeypatch.setattr(MeetingPoint, "_on_request", hear_the_second)
    monkeypatch.setattr(zenoh_meeting_point, "_await_free_port", await_free_port)
    sessions = {"owner": open_session()}
    sessions["guest"] = open_session()
    assert sessions["owner"].is_meeting_point
    router = zenoh_meeting_point.open_lone_router(router_configuration())
    assert not any(session.is_meeting_point for session in sessions.values())
    assert len(asked) == 2 * len(sessions)
    router.close()
    for session in sessions.values():
        session.close()


def test_a_router_that_takes_over_and_ends_soon_is_replaced_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(zenoh_meeting_point, "GIVE_WAY_S", 3600.0)
    opened = open_session()
    assert opened.is_meeting_point
    router = zenoh_meeting_point.open_lone_router(router_configuration())
    assert not opened.is_meeting_point
    wait_until(lambda: str(router.zid()) in {zid for zid, _ in opened.router_links()})
    wait_until(lambda: opened._meeting_point._asked_at is None)
    router.close()
    wait_until(lambda: opened.is_meeting_point)
    opened.close()


def test_a_router_that_asks_and_dies_is_replaced(
    start: Callable[..., Program], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(zenoh_meeting_point, "GIVE_WAY_S", 0.5)
    opened = open_session()
    assert opened.is_meeting_point
    assert zenoh_meeting_point._ask_to_give_way()
    wait_until(lambda: not opened.is_meeting_point)
    wait_until(lambda: opened.is_meeting_point)
    opened.close()
    assert not zenoh_meeting_point._ask_to_give_way()


def test_a_named_router_makes_no_meeting_point(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], port: int
) -> None:
    monkeypatch.setattr(zenoh_session, "CHECK_PERIOD_S", 0.2)
    elsewhere = f"tcp/127.0.0.1:{port + 1}"
    monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", f'connect/endpoints=["{elsewhere}"]')
    opened = open_session()
    assert not opened.is_meeting_point
    assert opened.endpoints == [elsewhere]
    opened.close()
    assert capsys.readouterr().err.startswith(
        f"tfloom: no router answers: {elsewhere} refuses: nothing listens there; start one there, by "
    )
    monkeypatch.setenv("ZENOH_ROUTER_CHECK_ATTEMPTS", "-1")
    open_session().close()
    assert capsys.readouterr().err == ""


def test_a_client_without_its_router_is_an_error(monkeypatch: pytest.MonkeyPatch, port: int) -> None:
    elsewhere = f"tcp/127.0.0.1:{port + 1}"
    monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", f'mode="client";connect/endpoints=["{elsewhere}"]')
    with pytest.raises(WireError, match=f"of mode client.*{elsewhere} refuses: nothing listens there"):
        open_session()


def test_waiting_for_a_router_without_end(
    monkeypatch: pytest.MonkeyPatch,
    start: Callable[..., Program],
    start_program: Callable[..., Program],
    port: int,
) -> None:
    monkeypatch.setenv("ZENOH_ROUTER_CHECK_ATTEMPTS", "0")
    monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", f'connect/endpoints=["tcp/127.0.0.1:{port + 1}"]')
    member = start("a", wait=False)
    member.wait_for("no router answers")
    assert "open" not in member.output
    monkeypatch.delenv("ZENOH_CONFIG_OVERRIDE")
    start_program("tfloom", "zenoh", "router", "-l", f"tcp/127.0.0.1:{port + 1}").wait_for("listening on")
    member.wait_for("open guest")


def test_ctrl_c_ends_the_wait_for_a_router(
    monkeypatch: pytest.MonkeyPatch, start: Callable[..., Program], port: int
) -> None:
    monkeypatch.setenv("ZENOH_ROUTER_CHECK_ATTEMPTS", "0")
    monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", f'connect/endpoints=["tcp/127.0.0.1:{port + 1}"]')
    member = start("a", wait=False)
    member.wait_for("no router answers")
    member.signal(signal.SIGINT)
    assert member.wait() in {1, -signal.SIGINT}
    assert "KeyboardInterrupt" in member.output


def test_off_has_no_link(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF")
    opened = open_session()
    assert not opened.is_meeting_point
    assert opened.endpoints == []
    assert opened.router_links() == []
    opened.close()
    assert capsys.readouterr().err == ""


def test_links_name_the_router(port: int) -> None:
    opened = open_session()
    ((zid, endpoint),) = opened.router_links()
    assert endpoint == f"tcp/127.0.0.1:{port}"
    assert zid != opened.zid
    opened.close()
    opened.close()
    with pytest.raises(ClosedError):
        opened.session  # noqa: B018


def test_no_thread_of_python_is_left() -> None:
    before = set(threading.enumerate())
    opened = open_session()
    assert {thread.name for thread in set(threading.enumerate()) - before} == {"tfloom_meeting_point"}
    opened.close()
    assert set(threading.enumerate()) <= before


def test_a_wrong_configuration_leaves_nothing_open(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ZENOH_ROUTER_CHECK_ATTEMPTS", "often")
    with pytest.raises(ConfigurationError, match="ZENOH_ROUTER_CHECK_ATTEMPTS"):
        open_session()
    monkeypatch.setenv("ZENOH_ROUTER_CHECK_ATTEMPTS", "1")
    monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", 'listen/endpoints=["tcp/192.0.2.1:7447"]')
    with pytest.raises(WireError, match=r"Zenoh can't open a session in domain 3, of mode peer"):
        open_session(3)
    assert "tfloom_meeting_point" not in {thread.name for thread in threading.enumerate()}
    monkeypatch.delenv("ZENOH_CONFIG_OVERRIDE")
    opened = open_session()
    assert opened.is_meeting_point  # so the router of the failed one was closed
    opened.close()


def test_refused_thread_leaves_nothing_open(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    with monkeypatch.context() as patched:
        patched.setattr(threading.Thread, "start", refuse)
        with pytest.raises(RuntimeError, match="can't start new thread"):
            open_session()
    opened = open_session()
    assert opened.is_meeting_point
    opened.close()


def test_takeover_survives_an_error(monkeypatch: pytest.MonkeyPatch, start: Callable[..., Program]) -> None:
    """A lack of descriptors at the moment of the takeover may pass; the next round tries again."""
    owner = start("owner")
    opened = open_session()
    tries = []

    def fail_twice(config: object) -> object:
        tries.append(config)
        if len(tries) < 3:
            raise zenoh_router.RouterError("too many open files")
        return zenoh_router.open_where_free(config)

    monkeypatch.setattr(zenoh_meeting_point, "open_where_free", fail_twice)
    owner.signal(signal.SIGKILL)
    wait_until(lambda: opened.is_meeting_point)
    assert len(tries) >= 3
    opened.close()


@needs_fork
def test_a_forked_child_is_refused_and_ends() -> None:
    code = """
import os, sys
from tfloom.rmw.errors import ForkedError
from tfloom.rmw.zenoh.config import meeting_point_configuration
from tfloom.rmw.zenoh.session import ZenohSession, open_session
opened = open_session()
child = os.fork()
if child == 0:
    for use in (lambda: opened.session, lambda: opened.zid, open_session):
        try:
            use()
        except ForkedError as error:
            assert "method 'spawn' or 'forkserver'" in str(error)
        else:
            os._exit(1)
    opened.close()
    sys.exit(3)
assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 3
assert opened.router_links()
opened.close()
"""
    done = run_to_end([sys.executable, "-W", "ignore::DeprecationWarning", "-c", code])
    assert (done.returncode, done.stderr) == (0, "")


ENDS = [
    ("pass", 0),
    ("raise ValueError('as asked')", 1),
    ("sys.exit(7)", 7),
    ("threading.Thread(target=flood, daemon=True).start(); time.sleep(0.05)", 0),
    ("signal.raise_signal(signal.SIGINT)", 1),
]
"""The last lines of a program, and its exit code."""


IMPORTS = """
import signal, sys, threading, time
from contextlib import suppress
import zenoh
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.zenoh.config import meeting_point_configuration
from tfloom.rmw.zenoh.session import ZenohSession, open_session
"""
NEVER_CLOSES = """
opened = open_session()
kept = opened.session.declare_subscriber("test/**", zenoh.handlers.Callback(lambda sample: None, indirect=False))
def flood():
    # Python aborts if a daemon thread prints, as of an exception, at the moment when the interpreter ends.
    with suppress(ClosedError, zenoh.ZError):
        while True:
            opened.session.put("test/data/flood", bytes(1000))
"""


@needs_fork
@pytest.mark.parametrize("role", ["owner", "guest"])
def test_a_program_that_never_closes_ends(
    role: str, start: Callable[..., Program], start_program: Callable[..., Program]
) -> None:
    if role == "guest":
        start("owner", "tick")
    outputs = outputs_by_end(start_program, IMPORTS, NEVER_CLOSES, [end for end, _ in ENDS])
    for (code, lines), (end, expected) in zip(outputs, ENDS, strict=True):
        assert code == expected or ("SIGINT" in end and code == -signal.SIGINT), lines
        assert "panicked" not in "".join(lines)


@pytest.mark.parametrize("role", ["owner", "guest"])
def test_what_was_written_before_the_close_arrives(role: str, start: Callable[..., Program]) -> None:
    members = {name: start(name) for name in ("first", "second")}
    sender, receiver = (
        (members["first"], members["second"]) if role == "owner" else (members["second"], members["first"])
    )
    name = "first" if role == "owner" else "second"
    wait_until(lambda: sees(receiver, "first", "second") and sees(sender, "first", "second"))
    # A sample that has arrived tells that the two have a direct link.
    wait_until(lambda: ask(sender, "send", 1, 10) and int(ask(receiver, "count", name)[2]) > 0)
    before = int(ask(receiver, "count", name)[2])
    tell(sender, "send", 2000, 5000)
    tell(sender, "close")
    sender.wait_for("closed")
    wait_until(lambda: int(ask(receiver, "count", name)[2]) >= before + 2000)
