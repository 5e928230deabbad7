"""The router of the Zenoh wire as a program: it starts, names who holds its port, and ends on a signal."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.conftest import Program, wait_until
from tests.zenoh_ports import hold_zenoh_port

from tfloom.rmw.zenoh_config import session_configuration

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


@pytest.mark.parametrize(
    ("words", "printed"),
    [
        (("-l", "nonsense"), 'Zenoh refuses listen/endpoints=["nonsense"]: Endpoints must be of the form'),
        (("-l", "tcp/192.0.2.1:7447"), "the router can't listen on tcp/192.0.2.1:7447: "),
        (("-c", "/no/such.json5"), "names /no/such.json5, which can't be read: No such file or directory"),
    ],
)
def test_wrong_arguments_are_one_line(
    words: tuple[str, ...], printed: str, start_program: Callable[..., Program]
) -> None:
    router = start_program("tfloom", "zenoh", "router", *words)
    assert router.wait() == 1
    assert printed in router.output
    assert len(router.lines) == 1


def test_a_peers_configuration_makes_no_router(tmp_path: Path, start_program: Callable[..., Program]) -> None:
    file = tmp_path / "router.json5"
    file.write_text('{mode: "peer"}')
    router = start_program("tfloom", "zenoh", "router", "-c", file)
    assert router.wait() == 1
    assert router.output == 'the configuration has the mode "peer", a router needs "router"'
