"""The processes of a measurement, and the configuration that the APIs share.

Each end runs in its own process, so that its CPU time and memory can be measured, and prints its result as JSON. All
traffic stays on the loopback interface, and every process ends with the measurement.
"""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from benchmarks.domain import DOMAIN_ID

if TYPE_CHECKING:
    from cyclonedds.domain import DomainParticipant
    from cyclonedds.pub import DataWriter
    from cyclonedds.sub import DataReader

APIS = ("tfloom", "cyclonedds")
PEER = "rclpy"
"""The real rclpy on Fast DDS, which `make ros-peer` installs. Its Python has none of tfloom's packages."""
BEFORE = "before"
"""tfloom of another commit: that of the environment whose Python BEFORE_VARIABLE names."""
BEFORE_VARIABLE = "TFLOOM_BEFORE_PYTHON"
ROOT = Path(__file__).parents[2]
MAX_DURATION_S = 60.0


def apis(*packages: str) -> tuple[str, ...]:
    """Return the APIs that can be measured: PEER if it is installed with the compiled interface `packages`."""
    from tools.ros_peer import NoPeerError, find

    try:
        peer = find()
    except NoPeerError:
        return APIS
    return (*APIS, PEER) if all(map(peer.has, packages)) else APIS


def start(
    role: str, *arguments: object, api: str = "tfloom", variables: dict[str, str] | None = None
) -> subprocess.Popen[str]:
    """Start `python -m benchmarks.node.<role> <arguments>`, by the Python that has `api`, with more variables."""
    added = variables or {}
    command = ["-m", f"benchmarks.node.{role}", *map(str, arguments)]
    if api == PEER:
        from tools.ros_peer import find

        pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
        return find().start(command, DOMAIN_ID, paths=[ROOT], cwd=ROOT, env=added, **pipes)
    environment = os.environ | {"ROS_DOMAIN_ID": str(DOMAIN_ID)} | added
    if api == "cyclonedds":  # each tfloom configures the library itself
        from tfloom.rmw.cyclone.config import configuration

        environment["CYCLONEDDS_URI"] = configuration()
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # use cached bytecode, as a user does
    return subprocess.Popen(
        [os.environ[BEFORE_VARIABLE] if api == BEFORE else sys.executable, *command],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env=environment,
        cwd=ROOT,
    )


def run(role: str, *arguments: object, api: str = "tfloom") -> Any:
    """Run a role to its end and return the JSON that it prints."""
    with background(role, *arguments, api=api) as process:
        text, _ = process.communicate(timeout=MAX_DURATION_S)
        if process.returncode != 0:
            raise RuntimeError(f"benchmarks.node.{role} ended with {process.returncode}")
        return json.loads(text)


@contextlib.contextmanager
def background(
    role: str, *arguments: object, api: str = "tfloom", variables: dict[str, str] | None = None
) -> Iterator[subprocess.Popen[str]]:
    """Run a role for the block."""
    process = start(role, *arguments, api=api, variables=variables)
    try:
        yield process
    finally:
        process.kill()
        process.wait()
        for pipe in (process.stdin, process.stdout):
            if pipe is not None:
                pipe.close()


def wait_for(condition: Callable[[], object]) -> None:
    """Wait until `condition()` is true.

    Raises:
        TimeoutError: it is false after `MAX_DURATION_S`.
    """
    end = time.monotonic() + MAX_DURATION_S
    while not condition():
        if time.monotonic() > end:
            raise TimeoutError("the other end was not discovered")
        time.sleep(0.005)


# cyclonedds' Python API


def cyclone_qos(depth: int | None = 10) -> Any:
    """Return ROS's quality of service: reliable, and a history of `depth`, or of all samples if None."""
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
    """Return a reader, and a function that waits for samples and takes at most as many as its argument."""
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
