"""What a latched publisher and its subscription leave in a process after their end, by nodes and by the library alone.

`python -m benchmarks.node.soak_pairs` makes and ends pairs, in a process of its own for each row, and prints by how
much its resident memory (RSS) grows a pair. On Zenoh the same is done without tfloom, by advanced publishers and
subscribers of eclipse-zenoh with the same options. The soak has these rows at its end.
"""

from __future__ import annotations

import argparse
import gc
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from benchmarks.domain import DOMAIN_ID

PAIRS = 200
WARM_UP_PAIRS = 50
DEPTH = 5
ROWS = {"nodes": "by nodes", "library": "by eclipse-zenoh alone"}


def reports(pairs: int, domain_id: int) -> list[str]:
    """Return a line for each row: for nodes on the wire of RMW_IMPLEMENTATION and, on Zenoh, for the library."""
    rows = ROWS if os.environ.get("RMW_IMPLEMENTATION") == "rmw_zenoh_cpp" else {"nodes": ROWS["nodes"]}
    lines = []
    for row, name in rows.items():
        command = [sys.executable, "-m", "benchmarks.node.soak_pairs"]
        options = ["--row", row, "--pairs", str(pairs), "--domain", str(domain_id)]
        grown = subprocess.run(
            [*command, *options], check=True, capture_output=True, text=True
        ).stdout.strip()
        lines.append(f"a latched publisher and subscription, {name}: {grown} kB a pair are left")
    return lines


def grown_kb(make_and_end: Callable[[], None], pairs: int) -> float:
    """Return by how much memory grows with each pair [kB], after the first ones."""
    for _ in range(WARM_UP_PAIRS):
        make_and_end()
    before = _resident_kb()
    for _ in range(pairs):
        make_and_end()
    return (_resident_kb() - before) / pairs


def _resident_kb() -> float:
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text("ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1024


def by_nodes(pairs: int, domain_id: int) -> float:
    """Return what a pair of a node leaves [kB]."""
    import rclpy
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import String

    rclpy.init(domain_id=domain_id)
    node = rclpy.create_node("pairs")
    latched = QoSProfile(depth=DEPTH, durability=DurabilityPolicy.TRANSIENT_LOCAL)

    def make_and_end() -> None:
        publisher = node.create_publisher(String, "latched", latched)
        subscription = node.create_subscription(String, "latched", lambda _: None, latched)
        node.destroy_subscription(subscription)
        node.destroy_publisher(publisher)

    grown = grown_kb(make_and_end, pairs)
    node.destroy_node()
    rclpy.shutdown()
    return grown


def by_library(pairs: int, domain_id: int) -> float:
    """Return what a pair of eclipse-zenoh leaves [kB], with the options of a latched one."""
    import zenoh
    import zenoh.ext as extension

    from tfloom.rmw.zenoh.config import session_configuration

    with zenoh.open(session_configuration()) as session:
        key = f"{domain_id}/latched/std_msgs::msg::dds_::String_/RIHS01_0"

        def make_and_end() -> None:
            publisher = extension.declare_advanced_publisher(
                session,
                key,
                cache=extension.CacheConfig(max_samples=DEPTH),
                publisher_detection=True,
                sample_miss_detection=extension.MissDetectionConfig(heartbeat=None, sporadic_heartbeat=0.5),
            )
            subscriber = extension.declare_advanced_subscriber(
                session,
                key,
                zenoh.handlers.Callback(lambda _: None, indirect=False),
                history=extension.HistoryConfig(detect_late_publishers=True, max_samples=DEPTH),
                recovery=extension.RecoveryConfig(periodic_queries=None, heartbeat=True),
                subscriber_detection=True,
            )
            subscriber.undeclare()
            publisher.undeclare()

        return grown_kb(make_and_end, pairs)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.node.soak_pairs", description=__doc__)
    parser.add_argument("--pairs", type=int, default=PAIRS, help="how many are made and ended")
    parser.add_argument("--domain", type=int, default=DOMAIN_ID, help=argparse.SUPPRESS)
    parser.add_argument("--row", choices=ROWS, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.row is None:
        print("\n".join(reports(arguments.pairs, arguments.domain)))
        return 0
    measure = by_nodes if arguments.row == "nodes" else by_library
    print(f"{measure(arguments.pairs, arguments.domain):.1f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
