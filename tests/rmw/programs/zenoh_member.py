"""A member of a Zenoh graph: prints the members that it sees whenever they change; argument: its name.

A line on stdin is a command: `send N SIZE` puts N samples and prints `send N`; `close` closes the session and prints
`closed`; `count NAME` prints how many samples of that member have come, and the longest time between two [s].
Arguments after the name are commands that are run first.
"""

from __future__ import annotations

import sys
import threading
import time
from itertools import pairwise

import zenoh

from tfloom.rmw.zenoh_session import open_session

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


def run(line: str) -> None:
    verb, *words = line.split()
    if verb == "send":
        for _ in range(int(words[0])):
            publisher.put(bytes(int(words[1])))
        say("send", words[0])
    elif verb == "close":
        is_sending.clear()
        opened.close()
        say("closed")
    elif verb == "tick":
        is_sending.set()
        threading.Thread(target=tick, daemon=True).start()
    elif verb == "owner":
        say("owner", opened.is_meeting_point)
    elif verb == "count":
        times = arrivals.get(words[0], [])
        gaps = [after - before for before, after in pairwise(times)]
        say("count", words[0], len(times), max(gaps, default=0.0))
    elif verb == "forget":
        arrivals.clear()
        say("forget")
    elif verb == "fail":
        raise SystemExit("failed as asked")


for command in commands:
    run(command)
for line in sys.stdin:
    run(line)
