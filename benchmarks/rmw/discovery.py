"""Measure how long processes take to know the graph as nodes grow, and what it costs.

    python -m benchmarks.rmw.discovery [--sizes 25 50]

Ten nodes a process, all started at one time. A row is one graph: the time until the last process knows all nodes, and
the CPU time of all processes until then, both from the moment at which the libraries were loaded.

On Cyclone DDS the nodes are tfloom's. On Zenoh they are their tokens, 16 a node as a node of rclpy has them, through
sessions that meet without a router: what the network does, without what a node adds.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time
from collections.abc import Callable

from benchmarks.domain import DOMAIN_ID

NODES_A_PROCESS = 10
TOKENS_A_NODE = 16
TIMEOUT_S = 120.0
PORT = 7397
"""The port at which Zenoh's sessions meet, another than that of the user's programs."""
SIZES = (25, 50, 100, 200)


def join_cyclone(number: int, own: int, total: int) -> Callable[[], bool]:
    """Create nodes of tfloom; return a function that tells whether all are known."""
    from tfloom.node.client_library import init
    from tfloom.node.node import Node

    init(args=[], domain_id=DOMAIN_ID)
    nodes = [Node(f"node_{number}_{index}") for index in range(own)]
    return lambda: len(nodes[0].get_node_names()) >= total


def join_zenoh(number: int, own: int, total: int) -> Callable[[], bool]:
    """Declare the tokens of nodes; return a function that tells whether all are known."""
    import zenoh

    from tfloom.rmw.zenoh_session import open_session

    opened = open_session(DOMAIN_ID)
    tokens: set[str] = set()
    session = opened.session
    kept: list[object] = [
        opened,
        session.liveliness().declare_subscriber(
            f"@ros2_lv/{DOMAIN_ID}/**",
            zenoh.handlers.Callback(lambda sample: tokens.add(str(sample.key_expr)), indirect=False),
            history=True,
        ),
    ]
    endpoint = "rcl_interfaces::srv::dds_::GetParameters_/RIHS01_" + "0" * 64 + "/::,10:,:,:,,"
    for index in range(own):
        node = f"@ros2_lv/{DOMAIN_ID}/{opened.zid}/{index}"
        name = f"%/%/node_{number}_{index}"
        kept.append(session.liveliness().declare_token(f"{node}/{index}/NN/{name}"))
        kept += [
            session.liveliness().declare_token(
                f"{node}/{100 * (index + 1) + entity}/SS/{name}/%node_{number}_{index}%s{entity}/{endpoint}"
            )
            for entity in range(TOKENS_A_NODE - 1)
        ]
    return lambda: kept is not None and len(tokens) >= total * TOKENS_A_NODE


WIRES = {"cyclonedds": join_cyclone, "zenoh": join_zenoh}


def work(wire: str, number: int, own: int, total: int) -> None:
    """Take part in one graph, as a process."""
    if wire == "zenoh":
        import zenoh  # noqa: F401
    else:
        import tfloom.node.node
        import tfloom.rmw.cyclonedds  # noqa: F401
    print("loaded", flush=True)
    sys.stdin.readline()
    cpu_s, start = time.process_time(), time.monotonic()
    is_complete = WIRES[wire](number, own, total)
    while not is_complete():
        if time.monotonic() - start > TIMEOUT_S:
            break
        time.sleep(0.02)
    print(is_complete(), time.monotonic() - start, time.process_time() - cpu_s, flush=True)
    sys.stdin.readline()


def measure(wire: str, total: int) -> tuple[bool, float, float]:
    """Return whether all processes knew the graph, the time of the last one [s], and the CPU time of all [s]."""
    shares = [min(NODES_A_PROCESS, total - first) for first in range(0, total, NODES_A_PROCESS)]
    environment = {**os.environ, "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp", "TFLOOM_ZENOH_PORT": str(PORT)}
    command = [sys.executable, "-m", "benchmarks.rmw.discovery", "--work", wire]
    workers = [
        subprocess.Popen(
            [*command, str(number), str(own), str(total)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=environment,
        )
        for number, own in enumerate(shares)
    ]
    try:
        for worker in workers:
            worker.stdout.readline()  # type: ignore[union-attr]
        for worker in workers:
            worker.stdin.write("go\n")  # type: ignore[union-attr]
            worker.stdin.flush()  # type: ignore[union-attr]
        results = [worker.stdout.readline().split() for worker in workers]  # type: ignore[union-attr]
    finally:
        for worker in workers:
            worker.kill()
            worker.communicate()  # closes its pipes, too
    is_complete = all(result[0] == "True" for result in results)
    return (
        is_complete,
        max(float(result[1]) for result in results),
        sum(float(result[2]) for result in results),
    )


def main() -> None:
    """Print a row for each wire and number of nodes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--work", nargs=4, metavar=("WIRE", "NUMBER", "OWN", "TOTAL"), help=argparse.SUPPRESS)
    parser.add_argument("--sizes", type=int, nargs="+", default=SIZES, help="numbers of nodes")
    args = parser.parse_args()
    if args.work:
        wire, *numbers = args.work
        work(wire, *map(int, numbers))
        return
    print(f"{'wire':<12}{'nodes':>6}{'processes':>11}{'complete':>10}{'time [s]':>10}{'CPU [s]':>9}")
    for wire in WIRES:
        for total in args.sizes:
            is_complete, time_s, cpu_s = measure(wire, total)
            processes = -(-total // NODES_A_PROCESS)
            print(
                f"{wire:<12}{total:>6}{processes:>11}{is_complete!s:>10}{time_s:>10.2f}{cpu_s:>9.2f}",
                flush=True,
            )


if __name__ == "__main__":
    main()
