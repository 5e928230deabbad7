"""Participants of this process, and peers in separate processes."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import Program, wait_until
from tests.zenoh_ports import NEEDS_ZENOH, use_port_of

from tfloom.rmw.base import NodeName, Participant, Reader, Topic
from tfloom.rmw.cyclone.wire import open_participant

PROGRAMS = Path(__file__).parent / "programs"
NODES = NodeName("/", "client"), NodeName("/a", "server")
WIRES = {"local": "local", "cyclonedds": "cyclone", "zenoh": "zenoh"}

Wires = tuple[Participant, Participant]


class Peer:
    """A process with a participant; each call writes one line to it and reads one line."""

    def __init__(self, program: Any, name: str) -> None:
        self.program = program
        self.pid = self("open", name)

    def __call__(self, verb: str, *arguments: object) -> Any:
        self.send(verb, *arguments)
        return self.answer()

    def send(self, verb: str, *arguments: object) -> None:
        self._next_line = len(self.program.lines)
        tell(self.program, json.dumps([verb, *arguments]))

    def answer(self) -> Any:
        end = time.monotonic() + 30
        while len(self.program.lines) <= self._next_line:
            assert self.program.process.poll() is None, self.program.output
            assert time.monotonic() < end, "the peer doesn't answer"
            time.sleep(0.001)
        return json.loads(self.program.lines[self._next_line])


def tell(program: Program, *words: object) -> None:
    """Write a line to a program's stdin."""
    program.process.stdin.write(" ".join(map(str, words)) + "\n")
    program.process.stdin.flush()


def ask(program: Program, *words: object, answer: str = "") -> list[str]:
    """Give a command, and return the words of the line that answers it: one that begins with the same word."""
    before = len(program.lines)
    tell(program, *words)

    def answers() -> list[list[str]]:
        lines = [line.split() for line in program.lines[before:]]
        return [line for line in lines if line[:1] == [answer or str(words[0])]]

    wait_until(answers)
    return answers()[0]


_FORK_FOR_EACH_END = """
import os
for end in ENDS:
    child = os.fork()
    if not child:
        exec(PROGRAM + end)
        break
    print("ended", os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
"""


def outputs_by_end(
    start_program: Callable[..., Program], imports: str, program: str, ends: Iterable[str]
) -> list[tuple[int, list[str]]]:
    """Run a program with each of these last lines, and return its exit codes, and the lines that it printed.

    Each is a fork of a process that has done the imports, which take longer than the rest.
    """
    code = f"{imports}\nPROGRAM, ENDS = {program!r}, {list(ends)!r}\n{_FORK_FOR_EACH_END}"
    # From 3.12 on Python warns about a fork with other threads, as numpy's are.
    forking = start_program("python", "-W", "ignore::DeprecationWarning", "-c", code)
    assert forking.wait() == 0, forking.output
    outputs: list[tuple[int, list[str]]] = []
    printed: list[str] = []
    for line in forking.lines:
        if line.startswith("ended "):
            outputs.append((int(line.split()[1]), printed))
            printed = []
        else:
            printed.append(line)
    return outputs


@contextmanager
def peers(start_program: Callable[..., Program]) -> Iterator[Callable[..., Peer]]:
    """Yield a function that starts peers, on the wire and the domain that the environment selects, by `start()`.

    Words are a command that starts it in turn, as one that enters a namespace.
    """
    started: list[Peer] = []

    def start(*words: str, **options: object) -> Peer:
        command = (*words, sys.executable, PROGRAMS / "peer.py")
        program = start_program(*command, stdin=subprocess.PIPE, **options)
        started.append(Peer(program, f"peer_{len(started)}"))
        return started[-1]

    yield start
    for peer in started:
        peer.program.process.stdin.close()


@pytest.fixture
def start_peer(domain_id: int, start_program: Callable[..., Any]) -> Iterator[Callable[..., Peer]]:
    """Start a peer on this test's domain; see `peers`."""
    with peers(start_program) as start:
        yield start


@pytest.fixture(
    params=[
        "local",
        pytest.param("cyclonedds", marks=pytest.mark.wire),
        pytest.param("zenoh", marks=NEEDS_ZENOH),
    ]
)
def wires(request: pytest.FixtureRequest, domain_id: int) -> Iterator[Wires]:
    """Yield two participants that discover each other, each with a node of `NODES`, on each wire."""
    module = import_module(f"tfloom.rmw.{WIRES[request.param]}.wire")
    with use_port_of(domain_id):
        here, there = module.open_participant(domain_id), module.open_participant(domain_id)
        here.add_node(NODES[0])
        there.add_node(NODES[1])
        yield here, there
        here.close()
        there.close()


@pytest.fixture
def participant(domain_id: int) -> Iterator[Participant]:
    """Yield a participant on DDS with one node, /tests/here."""
    participant = open_participant(domain_id)
    participant.add_node(NodeName("/tests", "here"))
    yield participant
    participant.close()


@pytest.fixture
def node() -> NodeName:
    return NodeName("/tests", "here")


@pytest.fixture
def topic() -> Topic:
    return Topic("/chatter", "std_msgs/msg/String", "RIHS01_" + "0" * 64)


@pytest.fixture
def take_data(wait_until: Callable[..., None]) -> Callable[[Reader, int], list[bytes]]:
    """Take `count` samples from a reader and return their bytes."""

    def take(reader: Reader, how_many: int) -> list[bytes]:
        taken: list[bytes] = []

        def enough() -> bool:
            taken.extend(sample.data for sample in iter(reader.take, None))
            return len(taken) >= how_many

        wait_until(enough, what=f"{how_many} samples")
        return taken

    return take
