"""foxglove_bridge, while a client is connected that takes nothing."""

from __future__ import annotations

import signal
import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager, suppress
from itertools import count
from pathlib import Path

import psutil
import pytest
from tests.conftest import Program, wait_until
from tests.foxglove.clients import TIMEOUT_S, Client, RawClient, bridging, connected

from tfloom.interfaces.std_msgs.msg import UInt8MultiArray
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.node import Node
from tfloom.rosidl import cdr

pytestmark = pytest.mark.wire
SIZE = 1_000_000
"""Size of a message [bytes]; the system's buffers of a connection take a few of them."""
MESSAGES = 60
THREADS = {"foxglove_bridge_stop", "foxglove_bridge_relay"}


@contextmanager
def stuck_client(port: int) -> Iterator[RawClient]:
    """Connect a client that subscribes to /big, and takes nothing from then on."""
    client = RawClient(port)
    with closing(client.socket):
        client.subscribe("/big", 1)
        yield client


def publish(publisher: Publisher[UInt8MultiArray], reader: Client, count: int) -> None:
    """Publish large messages, each when the one before has arrived at a client that reads."""
    for number in range(count):
        data = cdr.encode(UInt8MultiArray(data=bytes((number % 256,)) * SIZE))
        publisher.publish(data)
        reader.wait_for(lambda number=number: len(reader.messages) > number, f"message {number}")
        assert reader.messages[number] == (2, data)
        reader.messages[number] = 2, b""


def is_refused(port: int) -> bool:
    try:
        socket.create_connection(("127.0.0.1", port), timeout=TIMEOUT_S).close()
    except OSError:
        return True
    return False


def test_client_that_takes_nothing_delays_nobody(domain_id: int, node: Node) -> None:
    publisher = node.create_publisher(UInt8MultiArray, "/big", 1)
    with connected(domain_id) as reader:
        reader.subscribe("/big", 2)
        with stuck_client(reader.bridge.port):
            reader.wait_for(lambda: publisher.get_subscription_count() == 1, "the subscription")
            publish(publisher, reader, MESSAGES)


def test_client_that_takes_none_of_its_files_is_cut_off_and_others_get_theirs(
    domain_id: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("tfloom.foxglove.bridge.MAX_ASSET_BYTES", 8 * SIZE)
    path = tmp_path / "big.stl"
    path.write_bytes(bytes(range(250)) * (SIZE // 250))
    with bridging(domain_id, "asset_uri_allowlist:=['file://.*']") as bridge:
        reader = Client(bridge.port)
        numbers = count(1)

        def answer() -> tuple[int, str, bytes]:
            """Ask for the file, and return what the reader gets."""
            number = next(numbers)
            reader.send(op="fetchAsset", uri=path.as_uri(), requestId=number)
            reader.wait_for(lambda: number in reader.assets, "the answer")
            return reader.assets.pop(number)

        with closing(reader.socket):
            for _ in range(20):  # one that takes them may have as many as it wants
                assert answer() == (0, "", path.read_bytes())
            hostile = RawClient(bridge.port)
            with closing(hostile.socket):
                hostile.read_until(b"serverInfo")
                for number in range(30):
                    hostile.send(op="fetchAsset", uri=path.as_uri(), requestId=number)
                said = "is not sent while clients don't take the files before"
                reader.wait_for(lambda: answer()[0] == 1, "a refusal")
                reader.wait_for(lambda: said in reader.statuses(), "the reason")
                with bridge._asset_lock:  # others are counted for a moment before they are refused
                    assert bridge._asset_bytes <= 8 * SIZE
                monkeypatch.setattr("tfloom.foxglove.bridge.STUCK_S", 0.1)
                reader.wait_for(lambda: answer()[0] == 0, "the file, after the other one is cut off")
                with suppress(ConnectionError):
                    while hostile.socket.recv(65536):
                        pass
        assert "1 clients take nothing of the files they asked for" in capfd.readouterr().err


def test_close_returns_while_a_client_takes_nothing(
    domain_id: int, node: Node, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("tfloom.foxglove.bridge.STOP_S", 0.3)
    publisher = node.create_publisher(UInt8MultiArray, "/big", 1)
    with bridging(domain_id) as bridge:
        assert bridge.server is not None
        port = bridge.port
        reader = Client(port)
        reader.subscribe("/big", 2)
        with closing(reader.socket), stuck_client(port):
            reader.wait_for(lambda: publisher.get_subscription_count() == 1, "the subscription")
            publish(publisher, reader, MESSAGES)
            closed = threading.Thread(target=bridge.close, daemon=True)
            closed.start()
            closed.join(TIMEOUT_S)
            assert not closed.is_alive(), "close does not return"
            wait_until(lambda: is_refused(port))
            assert "A client takes nothing: its connection is cut" in capfd.readouterr().err
            # The client is still there, and nothing waits for it any more.
            assert THREADS.isdisjoint(thread.name for thread in threading.enumerate())


def test_close_waits_for_clients_that_take_their_messages(
    domain_id: int, capfd: pytest.CaptureFixture[str]
) -> None:
    with connected(domain_id) as client:
        client.bridge.close()
        assert THREADS.isdisjoint(thread.name for thread in threading.enumerate())
        client.wait_for(client.is_closed, "the closing message")
        assert "takes nothing" not in capfd.readouterr().err


def test_close_without_a_thread(domain_id: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The caller stops the server itself: the port is closed."""

    def refuse(_: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    with bridging(domain_id) as bridge:
        assert bridge.server is not None
        port = bridge.port
        with monkeypatch.context() as patched:
            patched.setattr(threading.Thread, "start", refuse)
            bridge.close()
        assert is_refused(port)


@pytest.mark.parametrize(
    ("number", "count"), [(signal.SIGINT, 2 * MESSAGES), (signal.SIGTERM, MESSAGES // 3)]
)
def test_program_ends_and_is_bounded_while_a_client_takes_nothing(
    number: signal.Signals, count: int, node: Node, start_bridge: Callable[..., tuple[Program, int]]
) -> None:
    publisher = node.create_publisher(UInt8MultiArray, "/big", 1)
    program, port = start_bridge("message_backlog_size:=8")
    reader = Client(port)
    reader.subscribe("/big", 2)
    with closing(reader.socket), stuck_client(port):
        reader.wait_for(lambda: publisher.get_subscription_count() == 1, "the subscription")
        processes = [psutil.Process(program.process.pid)]
        processes += processes[0].children(recursive=True)

        def memory() -> int:
            return sum(process.memory_info().rss for process in processes)

        before = memory()
        publish(publisher, reader, count)
        grown = memory() - before
        assert grown < MESSAGES * SIZE, f"{grown} bytes more for {count} messages that nobody takes"
        program.signal(number)
        assert program.wait() == 0
    assert "A client takes nothing: its connection is cut" in program.output
    assert "Traceback" not in program.output
