"""A driver in a separate process, which nothing that a viewer draws, loads or reads can delay.

Its stdin is a pipe whose other end only the viewer holds. When the viewer ends, however that was, the kernel closes it,
and the robots are stopped. Each line is a command of JSON: a list with the fields of a `Wish`, or the name of a page
that was closed. What it prints are lines, too: lists of a page and why its wish is not done.
"""

from __future__ import annotations

import json
import os
import queue
import signal
import threading
import time
from contextlib import closing, suppress

from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName
from tfloom.viewer.driving.driver import Driver, Wish, run_driver

__all__ = ["main"]

MAX_END_S = 5.0
"""How long it has to stop everything and end when the viewer has ended [s]."""
MAX_OPEN_S = 10.0
"""How long it has to open the wire before that [s]: it may be started to stop what a killed one has left."""
ENDS = ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT")
"""Signals that end it as the end of the viewer does: robots are stopped first."""


def main(arguments: list[str]) -> int:
    """Drive robots until stdin ends; the arguments are the domain, and the name of the node."""
    commands: queue.SimpleQueue[Wish | str | None] = queue.SimpleQueue()
    for name in ENDS:
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), lambda *_: commands.put(None))
    node = NodeName("/", arguments[1])
    is_open = threading.Event()
    try:
        threading.Thread(target=_read, args=(commands, is_open), daemon=True).start()
        with closing(open_participant(int(arguments[0]))) as participant:
            participant.add_node(node)
            is_open.set()
            run_driver(Driver(participant, node, _refuse), commands)
    except Exception as error:  # nothing else would report it
        _refuse("", f"nobody can drive: {error}")
        return 1
    return 0


def _read(commands: queue.SimpleQueue[Wish | str | None], is_open: threading.Event) -> None:
    # Not by sys.stdin, whose lock this thread would hold when the program ends by a signal: Python aborts then.
    rest = b""
    while data := os.read(0, 65536):
        *lines, rest = (rest + data).split(b"\n")
        for line in lines:
            command = json.loads(line)
            commands.put(command if isinstance(command, str) else Wish(*command))
    commands.put(None)
    is_open.wait(MAX_OPEN_S)
    time.sleep(MAX_END_S)
    os._exit(1)  # the wire has not let it end, and nobody else would


def _refuse(page: str, reason: str) -> None:
    with suppress(OSError):  # the viewer has ended
        print(json.dumps([page, reason]), flush=True)
