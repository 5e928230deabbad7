"""The processes that a measurement takes, and what both APIs need to meet one another.

Each end runs in a process of its own, so that CPU time and memory are its own; ends print their results as JSON.
All traffic stays on the loopback interface, and every process ends with the measurement.
"""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from benchmarks.domain import DOMAIN_ID
from tfloom.rmw.cyclone_config import configuration

if TYPE_CHECKING:
    from cyclonedds.domain import DomainParticipant
    from cyclonedds.pub import DataWriter
    from cyclonedds.sub import DataReader

APIS = ("tfloom", "cyclonedds")
LONGEST_S = 60.0


def start(role: str, *arguments: object) -> subprocess.Popen[str]:
    """Start `python -m benchmarks.node.<role> <arguments>`."""
    environment = os.environ | {"ROS_DOMAIN_ID": str(DOMAIN_ID), "CYCLONEDDS_URI": configuration()}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # a user's second start finds the bytecode of the first
    return subprocess.Popen(
        [sys.executable, "-m", f"benchmarks.node.{role}", *map(str, arguments)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env=environment,
    )


def run(role: str, *arguments: object) -> Any:
    """Run a role to its end and return what it prints."""
    with background(role, *arguments) as process:
        text, _ = process.communicate(timeout=LONGEST_S)
        if process.returncode != 0:
            raise RuntimeError(f"benchmarks.node.{role} ended with {process.returncode}")
        return json.loads(text)


@contextlib.contextmanager
def background(role: str, *arguments: object) -> Iterator[subprocess.Popen[str]]:
    """Run a role meanwhile."""
    process = start(role, *arguments)
    try:
        yield process
    finally:
        process.kill()
        process.wait()
        for pipe in (process.stdin, process.stdout):
            if pipe is not None:
                pipe.close()


def wait_for(condition: Callable[[], object]) -> None:
    """Wait until it's true.

    Raises:
        TimeoutError: it isn't after `LONGEST_S`.
    """
    end = time.monotonic() + LONGEST_S
    while not condition():
        if time.monotonic() > end:
            raise TimeoutError("the other end has not come")
        time.sleep(0.005)


# cyclonedds' own Python API


def cyclone_qos(depth: int | None = 10) -> Any:
    """Return what ROS asks for: reliable, and the last `depth`, or all."""
    from cyclonedds.qos import Policy, Qos

    history = Policy.History.KeepAll if depth is None else Policy.History.KeepLast(depth)
    return Qos(Policy.Reliability.Reliable(2**63 - 1), history)


def cyclone_writer(
    participant: DomainParticipant, topic: str, kind: type, depth: int | None = 10
) -> DataWriter:
    from cyclonedds.pub import DataWriter
    from cyclonedds.topic import Topic

    return DataWriter(participant, Topic(participant, topic, kind), qos=cyclone_qos(depth))


def cyclone_reader(
    participant: DomainParticipant, topic: str, kind: type, depth: int | None = 10
) -> tuple[DataReader, Callable[[int], Any]]:
    """Return a reader and how to wait for samples of its, of which it takes as many as asked for at most."""
    from cyclonedds.core import ReadCondition, SampleState, WaitSet
    from cyclonedds.sub import DataReader
    from cyclonedds.topic import Topic

    reader = DataReader(participant, Topic(participant, topic, kind), qos=cyclone_qos(depth))
    waitset = WaitSet(participant)
    waitset.attach(ReadCondition(reader, SampleState.NotRead))

    def receive(most: int) -> Any:
        while not (samples := reader.take(most)):
            waitset.wait(1_000_000_000)
        return samples

    return reader, receive
