"""The sockets of a domain that are bound to the loopback interface, and those that are not, on Linux."""

from __future__ import annotations

import ctypes
import os
import shutil
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from tests.conftest import run_to_end

from tfloom.rmw.cyclone import wire as cyclonedds
from tfloom.rmw.cyclone.config import configuration
from tfloom.rmw.cyclone.library import find_library

SO_BINDTOIFINDEX = 62
REFUSING = Path(__file__).parent / "libraries" / "refusing_kernel.c"

pytestmark = [
    pytest.mark.wire,
    pytest.mark.skipif(sys.platform != "linux", reason="other systems bind sockets in other ways"),
]


def sockets_of(domain_id: int) -> dict[int, str]:
    """Return the interface that each socket of this process on a domain's unicast ports is bound to, by port."""
    first = 7410 + 250 * domain_id
    devices: dict[int, str] = {}
    for entry in Path("/proc/self/fd").iterdir():
        with suppress(OSError):  # another thread has closed it
            if not entry.is_socket():
                continue
            with socket.socket(fileno=os.dup(int(entry.name))) as sock:
                port = sock.getsockname()[1] if sock.family == socket.AF_INET else 0
                if sock.type == socket.SOCK_DGRAM and first <= port < first + 240:
                    devices[port] = device_of(sock)
    return devices


def device_of(sock: socket.socket) -> str:
    """Return the interface that a socket is bound to, empty if none.

    It is asked for by number, because qemu-user, which knows integers alone, can't answer with a name.
    """
    index = sock.getsockopt(socket.SOL_SOCKET, SO_BINDTOIFINDEX)
    return socket.if_indextoname(index) if index else ""


@pytest.fixture
def opened(domain_id: int) -> Iterator[cyclonedds.CycloneParticipant]:
    participant = cyclonedds.CycloneParticipant(domain_id, "/")
    yield participant
    participant.close()


def test_the_sockets_of_a_domain_are_bound(domain_id: int, opened: cyclonedds.CycloneParticipant) -> None:
    first = 7410 + 250 * domain_id
    assert opened.loopback_failure == ""
    assert sockets_of(domain_id) == {first: "lo", first + 1: "lo"}
    second = cyclonedds.CycloneParticipant(domain_id, "/")
    assert second.loopback_failure == ""
    second.close()


@pytest.mark.parametrize(
    ("variable", "value"), [("CYCLONEDDS_URI", ""), ("ROS_STATIC_PEERS", "192.0.2.1")], ids=["uri", "peers"]
)
def test_a_configuration_that_reaches_others_is_not_bound(
    variable: str, value: str, domain_id: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    alone = configuration()
    earlier = sockets_of(domain_id)
    monkeypatch.setenv(variable, value or alone)
    # No packet is sent to another machine.
    monkeypatch.setattr(cyclonedds.cyclone_config, "configuration", lambda *_: alone)
    participant = cyclonedds.CycloneParticipant(domain_id, "/")
    try:
        assert participant.loopback_failure == ""
        ours = {port: device for port, device in sockets_of(domain_id).items() if port not in earlier}
        assert list(ours.values()) == ["", ""]
    finally:
        participant.close()


def test_other_sockets_of_the_process_stay_as_they_are(domain_id: int) -> None:
    """Among them is one on a port of the domain, and a thread opens and closes others."""
    first = 7410 + 250 * domain_id
    stop, faults = threading.Event(), []

    def open_and_close() -> None:
        while not stop.is_set():
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as another:
                another.bind(("", 0))
                if device_of(another):
                    faults.append(another.getsockname())

    thread = threading.Thread(target=open_and_close)
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as single,
        socket.socket(socket.AF_INET, socket.SOCK_STREAM) as of_tcp,
    ):
        single.bind(("", first + 101))
        of_tcp.bind(("", first + 100))
        thread.start()
        try:
            for _ in range(8):
                participant = cyclonedds.CycloneParticipant(domain_id, "/")
                assert sockets_of(domain_id)[first] == "lo"
                participant.close()
        finally:
            stop.set()
            thread.join()
        assert device_of(single) == device_of(of_tcp) == ""
    assert not faults


def test_a_domain_that_other_code_opened_is_reported(domain_id: int) -> None:
    library = ctypes.CDLL(find_library())
    domain = library.dds_create_domain(domain_id, configuration().encode())
    assert domain > 0
    participant = cyclonedds.CycloneParticipant(domain_id, "/")
    try:
        assert participant.loopback_failure == "other code in this process has opened the domain before"
        assert list(sockets_of(domain_id).values()) == ["", ""]
    finally:
        participant.close()
        library.dds_delete(domain)


@pytest.mark.skipif(shutil.which("cc") is None, reason="builds a library with cc")
def test_a_kernel_that_refuses_is_reported_and_nothing_fails(domain_id: int, tmp_path: Path) -> None:
    library = tmp_path / "refusing_kernel.so"
    subprocess.run(["cc", "-shared", "-fPIC", REFUSING, "-o", library, "-ldl"], check=True)
    preloaded = f"{os.environ.get('LD_PRELOAD', '')} {library}"  # a sanitizer's runtime is before it
    done = run_to_end([sys.executable, "-m", "tfloom", "doctor"], env={**os.environ, "LD_PRELOAD": preloaded})
    assert done.returncode == 0, done.stdout + done.stderr
    lines = done.stdout.splitlines()
    (reach,) = (line for line in lines if "reach:" in line)
    ports = f"two UDP ports from {7410 + 250 * domain_id} on"
    reason = "the kernel refused to bind them to lo: Operation not permitted"
    assert reach.startswith(
        f"warning  reach: {ports} aren't bound to loopback, because {reason}, on all interfaces: "
    )
    assert any("ok  round trip:" in line for line in lines)
