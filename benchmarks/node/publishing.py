"""Measure the CPU time of publishing a message: that of the whole process, with the wire's threads.

The receiver is the same for both APIs: it takes the bytes from the wire in C++ and drops them.
"""

from __future__ import annotations

import json
import sys
import time

from benchmarks.domain import DOMAIN_ID
from benchmarks.node.processes import APIS, background, cyclone_writer, run, wait_for

COUNTS = {"tfloom": 10_000, "cyclonedds": 500}
TURNS = 3


def tfloom(transforms: int, count: int) -> float:
    import rclpy
    from tf2_msgs.msg import TFMessage

    from benchmarks.node.messages import tf_message

    rclpy.init()
    publisher = rclpy.create_node("publisher").create_publisher(TFMessage, "bench", 10)
    message = tf_message(transforms)
    wait_for(publisher.get_subscription_count)
    begin = time.process_time()
    for _ in range(count):
        publisher.publish(message)
    return (time.process_time() - begin) / count * 1e6


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
    subscription.feed(SampleQueue(0))
    sys.stdin.read()


def measure(transforms: int) -> dict[str, float]:
    """Return the CPU time of a message for each API [us]: the minimum of some turns."""
    best = dict.fromkeys(APIS, float("inf"))
    with background("publishing", "receive"):
        for _ in range(TURNS):
            for api, count in COUNTS.items():
                best[api] = min(best[api], run("publishing", api, transforms, count))
    return best


if __name__ == "__main__":
    if sys.argv[1] == "receive":
        receive()
    else:
        publish_by = {"tfloom": tfloom, "cyclonedds": cyclonedds}[sys.argv[1]]
        print(json.dumps(publish_by(int(sys.argv[2]), int(sys.argv[3]))))
