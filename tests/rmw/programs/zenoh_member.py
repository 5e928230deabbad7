"""A member of a Zenoh graph: prints the members that it sees whenever they change; argument: its name.

A line on stdin is a command, and so is each argument after the name:

- `send N SIZE` puts N samples and prints `send N`
- `pace N SIZE PERIOD` does so with a period [s], as a reliable topic whose full queue drops, and prints `pace N`
- `tick` puts a sample each 10 ms
- `count NAME` prints how many samples of that member have come, and the longest time between two [s]
- `forget` forgets them, `owner` prints whether this process has the router, `close` closes the session
"""

from __future__ import annotations

import sys
import threading
import time
from itertools import pairwise

import zenoh

from tfloom.rmw.zenoh.session import open_session

name, *commands = sys.argv[1:]
members: set[str] = set()
arrivals: dict[str, list[float]] = {}
lock = threading.Lock()


def say(*words: object) -> None:
    with lock:
        print(*words, flush=True)


def on_token(sample: zenoh.Sample) -> None:
    """Zenoh's threads and the one that declares the own token call this."""
    member = str(sample.key_expr).rpartition("/")[2]
    with lock:
        before = sorted(members)
        (members.add if sample.kind == zenoh.SampleKind.PUT else members.discard)(member)
        if sorted(members) != before:
            print("sees", *sorted(members), flush=True)


def on_sample(sample: zenoh.Sample) -> None:
    arrivals.setdefault(str(sample.key_expr).rpartition("/")[2], []).append(time.monotonic())


opened = open_session(1)
say("open", "owner" if opened.is_meeting_point else "guest", opened.zid)
session = opened.session
direct = zenoh.handlers.Callback
entities = [
    session.declare_subscriber("test/data/*", direct(on_sample, indirect=False)),
    session.liveliness().declare_subscriber("test/members/*", direct(on_token, indirect=False), history=True),
    session.liveliness().declare_token(f"test/members/{name}"),
]
publisher = session.declare_publisher(f"test/data/{name}", congestion_control=zenoh.CongestionControl.BLOCK)
is_sending = threading.Event()


def tick() -> None:
    while is_sending.is_set():
        publisher.put(b"tick")
        time.sleep(0.01)


def send(count: str, size: str) -> None:
    for _ in range(int(count)):
        publisher.put(bytes(int(size)))
    say("send", count)


def pace(count: str, size: str, period_s: str) -> None:
    dropping = session.declare_publisher(f"test/data/{name}", congestion_control=zenoh.CongestionControl.DROP)
    start = time.monotonic()
    for number in range(int(count)):
        dropping.put(bytes(int(size)))
        time.sleep(max(0.0, start + (number + 1) * float(period_s) - time.monotonic()))
    dropping.undeclare()
    say("pace", count)


def start_ticks() -> None:
    is_sending.set()
    threading.Thread(target=tick, daemon=True).start()


def print_count(member: str) -> None:
    times = arrivals.get(member, [])
    gaps = [after - before for before, after in pairwise(times)]
    say("count", member, len(times), max(gaps, default=0.0))


def forget() -> None:
    arrivals.clear()
    say("forget")


def close() -> None:
    is_sending.clear()
    opened.close()
    say("closed")


VERBS = {
    "send": send,
    "pace": pace,
    "tick": start_ticks,
    "count": print_count,
    "forget": forget,
    "owner": lambda: say("owner", opened.is_meeting_point),
    "close": close,
}


def run(line: str) -> None:
    verb, *words = line.split()
    VERBS[verb](*words)


for command in commands:
    run(command)
for line in sys.stdin:
    run(line)
