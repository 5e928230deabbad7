"""Fill a domain with processes, each with one participant: `crowd.py DOMAIN_ID`.

All but the first and the last are stopped as soon as they have joined, because 119 that discover one another exchange
hundreds of thousands of packets.
"""

from __future__ import annotations

import ctypes
import os
import signal
import sys
import time

from tfloom.rmw.cyclone.config import local_participants
from tfloom.rmw.cyclone.ports import bound_indices
from tfloom.rmw.cyclone.wire import open_participant
from tfloom.rmw.errors import WireError

PR_SET_PDEATHSIG = 1
PATIENCE_S = 60.0


def join(domain_id: int, answers: int) -> None:
    """Join, write `joined` or the error, and then, when continued, whether there are two participants."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    try:
        participant = open_participant(domain_id)
    except WireError as error:
        os.write(answers, str(error).encode())
        os._exit(1)
    os.write(answers, b"joined")
    os.kill(os.getpid(), signal.SIGSTOP)
    end = time.monotonic() + PATIENCE_S
    while len(participant.graph._native.snapshot()[0]) < 2 and time.monotonic() < end:
        time.sleep(0.05)
    os.write(answers, b"True" if time.monotonic() < end else b"False")
    time.sleep(PATIENCE_S)


def start(domain_id: int) -> tuple[int, int, str]:
    """Return a new process, from where its answers are read, and the first of them."""
    reading, writing = os.pipe()
    pid = os.fork()
    if pid == 0:
        os.close(reading)
        join(domain_id, writing)
        os._exit(0)
    os.close(writing)
    answer = os.read(reading, 2000).decode()
    if answer == "joined":
        os.waitpid(pid, os.WUNTRACED)
    return pid, reading, answer


def main(domain_id: int) -> None:
    crowd = [start(domain_id) for _ in range(local_participants(domain_id))]
    print("joined:", sum(answer == "joined" for _, _, answer in crowd), flush=True)
    ends = (crowd[0], crowd[-1])
    for pid, _, _ in ends:
        os.kill(pid, signal.SIGCONT)
    met = all(os.read(reading, 100) == b"True" for _, reading, _ in ends)
    print("the first and the last have discovered each other:", met, flush=True)
    print("a stopped one holds its port:", len(bound_indices(domain_id)) == len(crowd), flush=True)
    print("the next:", start(domain_id)[2], flush=True)
    for pid, _, _ in crowd:
        os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)


if __name__ == "__main__":
    main(int(sys.argv[1]))
