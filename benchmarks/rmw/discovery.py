"""Measure how long processes take to know the graph as nodes grow, and what it costs.

    python -m benchmarks.rmw.discovery [--sizes 25 50]

Ten nodes of tfloom a process, each with a publisher and a subscription of its own and a publisher of one topic that all
share. On Zenoh one router, a process of its own, is running before. All processes start at one time; when all of them
know the graph, another process joins with one node. A row is one graph:

- complete: each process, the newcomer too, has exactly the names of all nodes, and counts of publishers and
  subscriptions that are right, for the shared topic and for the topic of the last node;
- time, CPU: until the last process knows all, and what all of them have computed, from the moment at which the
  libraries were loaded;
- join, bytes: the time until the newcomer knows all, and what the loopback interface has carried meanwhile, without
  what it carries in as long a time before;
- memory: the mean of the processes' own memory (proportional set size), the newcomer's and the router's left out.
"""

from __future__ import annotations

import argparse
import os
import select
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, NamedTuple

from benchmarks.domain import DOMAIN_ID

NODES_A_PROCESS = 10
TIMEOUT_S = 120
PORT = 7397
"""The port of Zenoh's router, another than that of the user's programs."""
SIZES = (25, 50, 100, 200)
SHARED = "/discovery/shared"
NEWCOMER = -1
"""The number of the process that joins when all others know the graph."""
WIRES = {"cyclonedds": "rmw_cyclonedds_cpp", "zenoh": "rmw_zenoh_cpp"}
LOOPBACK = Path("/sys/class/net/lo/statistics/tx_bytes")


class Row(NamedTuple):
    """What one graph has shown."""

    is_complete: bool
    time_s: float
    cpu_s: float
    join_s: float
    join_bytes: int
    memory_bytes: int


def node_name(number: int, index: int) -> str:
    """Return the name of a process's node."""
    return f"newcomer_{index}" if number == NEWCOMER else f"node_{number}_{index}"


def shares_of(total: int) -> list[int]:
    """Return how many nodes each process has."""
    return [min(NODES_A_PROCESS, total - first) for first in range(0, total, NODES_A_PROCESS)]


def join(number: int, own: int, total: int) -> Callable[[], str]:
    """Create nodes; return a function that tells what of the graph is not as it must be, empty if nothing.

    Args:
        number: The number of this process.
        own: How many nodes it has.
        total: How many nodes all processes have, the newcomer left out.
    """
    from std_msgs.msg import String

    from tfloom.node.client_library import init
    from tfloom.node.node import Node

    init(args=[], domain_id=DOMAIN_ID)
    nodes = [Node(node_name(number, index)) for index in range(own)]
    for node in nodes:
        node.create_publisher(String, SHARED, 1)
        node.create_publisher(String, f"/discovery/{node.get_name()}", 1)
        node.create_subscription(String, f"/discovery/{node.get_name()}", lambda _: None, 1)
    expected = sorted(
        [
            node_name(process, index)
            for process, share in enumerate(shares_of(total))
            for index in range(share)
        ]
        + ([node_name(NEWCOMER, 0)] if number == NEWCOMER else [])
    )
    last_topic = f"/discovery/{node_name(len(shares_of(total)) - 1, shares_of(total)[-1] - 1)}"

    def difference() -> str:
        names = sorted(nodes[0].get_node_names())
        counts = (
            nodes[0].count_publishers(SHARED),
            nodes[0].count_publishers(last_topic),
            nodes[0].count_subscribers(last_topic),
        )
        right = (len(expected), 1, 1)
        return f"{len(names)}_of_{len(expected)}_names,counts_{counts}".replace(" ", "") * (
            names != expected or counts != right
        )

    return difference


def work(number: int, own: int, total: int, timeout_s: int) -> None:
    """Take part in one graph, as a process."""
    import std_msgs.msg  # noqa: F401

    import tfloom.node.node

    if os.environ["RMW_IMPLEMENTATION"] == WIRES["zenoh"]:
        import zenoh  # noqa: F401
    else:
        import tfloom.rmw.cyclone.wire  # noqa: F401
    print("loaded", flush=True)
    sys.stdin.readline()
    cpu_s, start = time.process_time(), time.monotonic()
    difference = join(number, own, total)
    while (missing := difference()) and time.monotonic() - start < timeout_s:
        time.sleep(0.02)
    print(missing or "complete", time.monotonic() - start, time.process_time() - cpu_s, flush=True)
    sys.stdin.readline()


def proportional_bytes(pid: int) -> int:
    """Return a process's own memory: its pages, each divided by the processes that have it."""
    lines = Path(f"/proc/{pid}/smaps_rollup").read_text("ascii").splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("Pss:")) * 1024


def read_line(stream: IO[str]) -> str:
    """Return the next line; raise TimeoutError where none comes."""
    if not select.select([stream], [], [], 2 * TIMEOUT_S)[0]:
        raise TimeoutError("a process of the benchmark doesn't answer")
    return stream.readline()


class Worker:
    """A process that takes part."""

    def __init__(self, environment: dict[str, str], *words: str) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-m", *words],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=environment,
        )

    def read(self) -> str:
        """Return its next line."""
        assert self.process.stdout is not None
        return read_line(self.process.stdout)

    def start(self) -> None:
        """Let it join."""
        assert self.process.stdin is not None
        self.process.stdin.write("go\n")
        self.process.stdin.flush()

    def result(self) -> tuple[bool, float, float]:
        """Return whether it knows the graph, and its time and CPU time until then [s]."""
        missing, time_s, cpu_s = self.read().split()
        if missing != "complete":
            print(f"process {self.process.pid}: {missing}", file=sys.stderr)
        return missing == "complete", float(time_s), float(cpu_s)


@contextmanager
def workers_of(wire: str) -> Iterator[Callable[..., Worker]]:
    """Return what starts a process on a wire, by its words after `python -m`; end all of them."""
    started: list[Worker] = []
    environment = {
        **os.environ,
        "RMW_IMPLEMENTATION": WIRES[wire],
        "TFLOOM_ZENOH_PORT": str(PORT),
        "ROS_DOMAIN_ID": str(DOMAIN_ID),
    }

    def start(*words: object) -> Worker:
        started.append(Worker(environment, *map(str, words)))
        return started[-1]

    try:
        if wire == "zenoh":
            router = start("tfloom", "zenoh", "router")
            while "listening on" not in (line := router.read()):
                if not line:
                    raise RuntimeError("the router has ended")
        yield start
    finally:
        for worker in started:
            worker.process.kill()
            worker.process.communicate()  # closes its pipes, too


def bytes_during(seconds: float) -> int:
    """Return what the loopback interface carries in a time."""
    before = int(LOOPBACK.read_text("ascii"))
    time.sleep(seconds)
    return int(LOOPBACK.read_text("ascii")) - before


def measure(wire: str, total: int) -> Row:
    """Return what one graph shows."""
    me = "benchmarks.rmw.discovery"
    with workers_of(wire) as start:
        workers = [
            start(me, "--work", number, own, total, TIMEOUT_S) for number, own in enumerate(shares_of(total))
        ]
        newcomer = start(me, "--work", NEWCOMER, 1, total, TIMEOUT_S)
        for worker in (*workers, newcomer):
            worker.read()
        for worker in workers:
            worker.start()
        results = [worker.result() for worker in workers]
        quiet_bytes_a_second = bytes_during(1.0)
        before = int(LOOPBACK.read_text("ascii"))
        newcomer.start()
        joined, join_s, _ = newcomer.result()
        carried = int(LOOPBACK.read_text("ascii")) - before
        memory = [proportional_bytes(worker.process.pid) for worker in workers]
    return Row(
        joined and all(is_complete for is_complete, _, _ in results),
        max(time_s for _, time_s, _ in results),
        sum(cpu_s for _, _, cpu_s in results),
        join_s,
        max(0, carried - round(quiet_bytes_a_second * join_s)),
        sum(memory) // len(memory),
    )


def main() -> None:
    """Print a row for each wire and number of nodes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--work",
        nargs=4,
        type=int,
        metavar=("NUMBER", "OWN", "TOTAL", "TIMEOUT_S"),
        help=argparse.SUPPRESS,
    )
    parser.add_argument("--sizes", type=int, nargs="+", default=SIZES, help="numbers of nodes")
    args = parser.parse_args()
    if args.work:
        work(*args.work)
        return
    print(
        f"{'wire':<12}{'nodes':>6}{'processes':>11}{'complete':>10}{'time [s]':>10}{'CPU [s]':>9}"
        f"{'join [s]':>10}{'bytes [kB]':>12}{'memory [MB]':>13}"
    )
    for wire in WIRES:
        for total in args.sizes:
            row = measure(wire, total)
            print(
                f"{wire:<12}{total:>6}{len(shares_of(total)):>11}{row.is_complete!s:>10}{row.time_s:>10.2f}"
                f"{row.cpu_s:>9.2f}{row.join_s:>10.2f}{row.join_bytes / 1e3:>12.0f}{row.memory_bytes / 1e6:>13.1f}",
                flush=True,
            )


if __name__ == "__main__":
    main()
