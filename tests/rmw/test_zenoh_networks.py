"""Two hosts as network namespaces, each with a router, joined by a cable that is slow, cut, or mended."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.conftest import TIMEOUT_S, Program, run_to_end, wait_until
from tests.namespaces import CABLE, Host, hosts_on_a_subnet
from tests.rmw.conftest import ask
from tests.zenoh_ports import hold_zenoh_port

pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")

PROGRAMS = Path(__file__).parent / "programs"
MEMBER = PROGRAMS / "zenoh_member.py"
NODE = PROGRAMS / "zenoh_site_node.py"
LEASE_S = 2.0
# A queue of 3 packets, so that TCP loses some of each burst.
SLOW = ("tbf", "rate", "4mbit", "burst", "3000", "limit", "4500")


class Site:
    """A host with a router and members."""

    def __init__(self, host: Host, start_program: Callable[..., Program], *router_words: str) -> None:
        self.host = host
        self._start = start_program
        self._router_words = router_words
        self.router = self.start_router()

    def start_router(self) -> Program:
        """Start the host's router, and return it when it listens."""
        command = (sys.executable, "-m", "tfloom", "zenoh", "router", *self._router_words)
        self.router = self._start(*self.host.enter, *command)
        self.router.wait_for("listening on")
        return self.router

    def member(self, name: str) -> Program:
        """Start a member, and return it when its session is open."""
        member = self._start(*self.host.enter, sys.executable, MEMBER, name, stdin=subprocess.PIPE)
        member.wait_for("open guest")
        return member

    def node(self, name: str, other: str) -> Program:
        """Start a node that checks what comes from another one, and return it when it is ready."""
        node = self._start(*self.host.enter, sys.executable, NODE, name, other, stdin=subprocess.PIPE)
        node.wait_for("ready")
        return node


@pytest.fixture
def sites(
    start_program: Callable[..., Program], monkeypatch: pytest.MonkeyPatch
) -> Iterator[tuple[Site, Site]]:
    """Return two hosts whose routers are joined: the far one connects to the near one."""
    with hold_zenoh_port() as port:
        monkeypatch.setenv("TFLOOM_LEASE_S", str(LEASE_S))
        near, far = hosts_on_a_subnet(start_program)
        listen = ("-l", f"tcp/127.0.0.1:{port}", "-l", f"tcp/{near.address}:{port}")
        yield Site(near, start_program, *listen), Site(far, start_program, "-e", f"tcp/{near.address}:{port}")


def graph(program: Program) -> list[str]:
    return next((line.split()[1:] for line in reversed(program.lines) if line.startswith("sees")), [])


def count(program: Program, name: str) -> int:
    return int(ask(program, "count", name)[2])


def test_nothing_is_lost_within_the_rate_of_the_link(sites: tuple[Site, Site]) -> None:
    near, far = sites
    for site in sites:
        command = [*site.host.enter, "tc", "qdisc", "add", "dev", CABLE, "root", *SLOW]
        done = run_to_end(command)
        if "kind is unknown" in done.stderr:
            pytest.skip("this kernel has no tbf")
        assert done.returncode == 0, done.stderr
    sender, receiver = near.member("sender"), far.member("receiver")
    wait_until(lambda: graph(receiver) == graph(sender) == ["receiver", "sender"])
    # The first sample that arrives tells that the subscription has reached the sender.
    wait_until(lambda: ask(sender, "send", 1, 10) and count(receiver, "sender") > 0)
    wait_until(lambda: count(receiver, "sender") == count(sender, "sender"))
    before = count(receiver, "sender")
    ask(sender, "pace", 300, 1500, 0.01)  # /tf of ten transforms at 100 Hz, 1.2 Mbit/s
    wait_until(lambda: count(receiver, "sender") >= before + 300)
    assert count(receiver, "sender") == before + 300


def test_a_short_cut_loses_nothing_and_after_a_long_one_all_pass_again(sites: tuple[Site, Site]) -> None:
    """A link that is back before its lease has ended goes on where it was."""
    near, far = sites
    sender, receiver = near.member("sender"), far.member("receiver")
    wait_until(lambda: graph(receiver) == graph(sender) == ["receiver", "sender"])
    wait_until(lambda: ask(sender, "send", 1, 10) and count(receiver, "sender") > 0)
    wait_until(lambda: count(receiver, "sender") == count(sender, "sender"))
    before = count(receiver, "sender")
    near.host.run("ip", "link", "set", CABLE, "down")
    ask(sender, "send", 100, 100)
    near.host.run("ip", "link", "set", CABLE, "up")
    wait_until(lambda: count(receiver, "sender") == before + 100)
    assert not any(
        line == "sees receiver" for line in receiver.lines[receiver.lines.index("sees receiver sender") :]
    )
    near.host.run("ip", "link", "set", CABLE, "down")
    wait_until(lambda: graph(receiver) == ["receiver"] and graph(sender) == ["sender"])
    near.host.run("ip", "link", "set", CABLE, "up")
    wait_until(lambda: graph(receiver) == graph(sender) == ["receiver", "sender"])
    before = count(receiver, "sender")
    wait_until(lambda: ask(sender, "send", 1, 10) and count(receiver, "sender") > before)


@pytest.mark.timing
def test_the_graph_is_whole_again_after_a_restart(sites: tuple[Site, Site]) -> None:
    near, far = sites
    sender, receiver = near.member("sender"), far.member("receiver")
    wait_until(lambda: graph(receiver) == graph(sender) == ["receiver", "sender"])
    for site in sites:
        site.router.end()
        wait_until(lambda: graph(receiver) == ["receiver"] and graph(sender) == ["sender"])
        site.start_router()
        restarted = time.monotonic()
        while not graph(receiver) == graph(sender) == ["receiver", "sender"]:
            assert time.monotonic() - restarted < TIMEOUT_S, "\n\n".join(
                program.output for program in (near.router, sender, far.router, receiver)
            )
            time.sleep(0.01)
        before = count(receiver, "sender")
        wait_until(lambda before=before: ask(sender, "send", 1, 10) and count(receiver, "sender") > before)
        assert time.monotonic() - restarted < 5.0


def test_topics_and_services_pass_again_after_a_restart(
    sites: tuple[Site, Site], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
    near, far = sites
    nodes = {"near": near.node("near", "far"), "far": far.node("far", "near")}

    def check(word: str) -> None:
        for name, node in nodes.items():
            other = "far" if name == "near" else "near"
            assert ask(node, word) == [word, "sent", "kept", other]

    check("before")
    for number, site in enumerate((near, far, near, far)):
        site.router.end()
        site.start_router()
        check(f"after{number}")
