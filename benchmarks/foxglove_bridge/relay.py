"""What the relay of foxglove_bridge costs: CPU of the process, and the time from the SDK to a client.

A process logs numbered messages to foxglove-sdk's server at a constant rate, as the bridge does with what it reads. A
client is connected to the server once by the relay, and once without it; each message has to arrive, in order and as it
was sent. The peer is the way without the relay. At the end, the process is busy in Python meanwhile, as a bridge with
much to do is, because the relay needs the GIL.
"""

from __future__ import annotations

import hashlib
import multiprocessing
import statistics
import struct
import sys
import threading
import time
from contextlib import closing
from multiprocessing.connection import Connection
from typing import NamedTuple

import foxglove
from foxglove import Channel, Context, Schema
from websockets.sync.client import connect

from tfloom.common.inner_port import InnerPort
from tfloom.foxglove.relay import SWITCH_INTERVAL_S, Relay, listen

SECONDS = 5.0
CASES = ((100, 1000.0), (10_000, 1000.0), (1_000_000, 50.0))
"""Size [bytes] and rate [Hz] of messages."""
HEAD = struct.Struct("<Qd")
"""The number of a message, and when it was sent [s, monotonic], at its begin."""


class Case(NamedTuple):
    """What is measured at once."""

    size: int
    rate_hz: float
    is_relayed: bool
    is_busy: bool

    @property
    def count(self) -> int:
        """Number of messages."""
        return round(SECONDS * self.rate_hz)


def body(case: Case, number: int) -> bytes:
    """Return what comes after the head of a message."""
    return hashlib.sha256(struct.pack("<Q", number)).digest() * ((case.size - HEAD.size) // 32)


def serve(case: Case, pipe: Connection) -> None:
    """Serve messages until all are sent, and say the CPU that this took [s]."""
    sys.setswitchinterval(SWITCH_INTERVAL_S)
    context = Context()
    inner = InnerPort()
    if not case.is_relayed:
        inner.host = "127.0.0.1"
    server = foxglove.start_server(host=inner.host, port=0, context=context, message_backlog_size=1000)
    schema = Schema(name="numbers", encoding="ros2msg", data=b"")
    channel = Channel("numbers", schema=schema, message_encoding="cdr", context=context)
    relay = None
    if case.is_relayed:
        assert inner.close_to_others(server.port)
        relay = Relay(listen("127.0.0.1", 0), None, inner, lambda _: "")
        relay.start()
    pipe.send(server.port if relay is None else relay.port)
    pipe.recv()
    is_over = threading.Event()
    busy = threading.Thread(target=compute, args=(is_over,))
    if case.is_busy:
        busy.start()
    bodies = [body(case, number) for number in range(16)]
    begin_s, begin_cpu_s = time.monotonic(), time.process_time()
    for number in range(case.count):
        time.sleep(max(0.0, begin_s + number / case.rate_hz - time.monotonic()))
        channel.log(HEAD.pack(number, time.monotonic()) + bodies[number % 16])
    pipe.send(time.process_time() - begin_cpu_s)
    pipe.recv()
    is_over.set()
    if relay is not None:
        relay.close(0.0)
    server.stop()


def compute(is_over: threading.Event) -> None:
    """Hold the GIL as much as Python lets a thread."""
    while not is_over.is_set():
        sum(range(1000))


def measure(case: Case) -> tuple[float, list[float]]:
    """Return the CPU [cores], and the delays of all messages [s]."""
    ours, theirs = multiprocessing.get_context("spawn").Pipe()
    process = multiprocessing.get_context("spawn").Process(target=serve, args=(case, theirs))
    process.start()
    delays: list[float] = []
    bodies = [body(case, number) for number in range(16)]
    with connect(
        f"ws://127.0.0.1:{ours.recv()}", subprotocols=["foxglove.sdk.v1"], max_size=None, proxy=None
    ) as client:  # type: ignore[list-item]
        while '"advertise"' not in (text := client.recv(timeout=10.0)):
            pass
        channel = int(str(text).split('"id":')[1].split(",")[0])
        client.send(f'{{"op": "subscribe", "subscriptions": [{{"id": 1, "channelId": {channel}}}]}}')
        time.sleep(0.2)
        ours.send(None)
        while len(delays) < case.count:
            data = client.recv(timeout=10.0)
            if isinstance(data, str):
                continue
            now_s = time.monotonic()
            number, sent_s = HEAD.unpack_from(data, 13)
            assert number == len(delays), f"message {len(delays)} is lost"
            assert data[13 + HEAD.size :] == bodies[number % 16], "a message has changed"
            delays.append(now_s - sent_s)
        cpu_s: float = ours.recv()
        ours.send(None)
    with closing(process):
        process.join()
    return cpu_s / SECONDS, delays


def main() -> None:
    print("foxglove-sdk's server by the relay and without it; every message has arrived as it was sent")
    print(f"{'messages':34} {'way':8} {'cores':>6} {'median':>9} {'99 of 100 within':>17}")
    for is_busy in (False, True):
        for size, rate_hz in CASES:
            for is_relayed in (False, True):
                case = Case(size, rate_hz, is_relayed, is_busy)
                cores, delays = measure(case)
                what = f"{size} bytes at {rate_hz:g} Hz" + (", busy" if is_busy else "")
                within = statistics.quantiles(delays, n=100)[98]
                way = "relay" if is_relayed else "without"
                print(
                    f"{what:34} {way:8} {cores:6.2f} {1e3 * statistics.median(delays):6.2f} ms {1e3 * within:14.2f} ms"
                )
