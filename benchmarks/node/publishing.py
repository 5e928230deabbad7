"""Measure the CPU time of publishing a message: that of the whole process, with the wire's threads.

The receiver is the same for both APIs: it takes the bytes from the wire in C++ and drops them.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Sequence

from benchmarks.domain import DOMAIN_ID
from benchmarks.node.processes import BEFORE, background, cyclone_writer, run, wait_for
from benchmarks.node.round_trip import line

COUNTS = {"tfloom": 10_000, "cyclonedds": 500, "rclpy": 1000}
SETTLING_S = 0.5
"""Time until the receiver of another vendor has matched, too."""
ARRIVING = 0.9
"""The least share of the messages that arrives, because a writer with a history of 10 may overwrite samples."""
TURNS = 3


def ros(transforms: int, count: int) -> float:
    import rclpy.duration
    from tf2_msgs.msg import TFMessage

    from benchmarks.node.messages import tf_message

    rclpy.init()
    publisher = rclpy.create_node("publisher").create_publisher(TFMessage, "bench", 10)
    message = tf_message(transforms)
    wait_for(publisher.get_subscription_count)
    time.sleep(SETTLING_S)
    begin = time.process_time()
    for _ in range(count):
        publisher.publish(message)
    cost_us = (time.process_time() - begin) / count * 1e6
    publisher.wait_for_all_acked(rclpy.duration.Duration(seconds=5))
    return cost_us


def cyclonedds(transforms: int, count: int) -> float:
    from cyclonedds.domain import DomainParticipant

    from benchmarks.node import cyclone_types

    writer = cyclone_writer(DomainParticipant(DOMAIN_ID), "rt/bench", cyclone_types.TFMessage)
    message = cyclone_types.tf_message(transforms, cyclone_types.Time(0, 0))
    wait_for(writer.get_matched_subscriptions)
    begin = time.process_time()
    for _ in range(count):
        writer.write(message)
    return (time.process_time() - begin) / count * 1e6


def receive() -> None:
    import rclpy
    from tf2_msgs.msg import TFMessage

    from tfloom._native import SampleQueue

    rclpy.init()
    subscription = rclpy.create_node("receiver").create_subscription(TFMessage, "bench", print, 10)
    queue = SampleQueue(0)
    subscription.feed(queue)
    for _ in sys.stdin:
        print(queue.pushed(), flush=True)


def measure(transforms: int, some: Sequence[str]) -> dict[str, float]:
    """Return the CPU time of a message for each API [us]: the minimum of some turns."""
    best = dict.fromkeys(some, float("inf"))
    with background("publishing", "receive") as receiver:
        for _ in range(TURNS):
            for api in best:
                count = COUNTS["tfloom" if api == BEFORE else api]
                before = int(line(receiver, ""))
                cost = run("publishing", api, transforms, count, api=api)
                received = int(line(receiver, "")) - before
                if not ARRIVING * count < received <= count:
                    raise RuntimeError(f"{received} of {count} messages of {api} arrived")
                best[api] = min(best[api], cost)
    return best


if __name__ == "__main__":
    if sys.argv[1] == "receive":
        receive()
    else:
        publish_by = cyclonedds if sys.argv[1] == "cyclonedds" else ros
        print(json.dumps(publish_by(int(sys.argv[2]), int(sys.argv[3]))))
