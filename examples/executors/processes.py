"""Compute in worker processes, each with a node of its own: `processes.py spawn`, or `processes.py fork`."""

from __future__ import annotations

import multiprocessing
import sys
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32

WORKERS = 3


def work(number: int) -> None:
    """Publish the square of `number`; in a process of its own, because nothing of the parent's nodes works here."""
    rclpy.init(args=[])
    node = Node(f"worker{number}")
    publisher = node.create_publisher(Int32, "squares", 10)
    while publisher.get_subscription_count() == 0:
        time.sleep(0.01)
    publisher.publish(Int32(data=number**2))
    publisher.wait_for_all_acked()
    node.destroy_node()
    rclpy.shutdown()


def main(method: str) -> None:
    rclpy.init(args=[])
    node = Node("collector")
    squares: list[int] = []
    node.create_subscription(Int32, "squares", lambda message: squares.append(message.data), 10)
    multiprocessing.set_start_method(method)
    workers = [multiprocessing.Process(target=work, args=(number,)) for number in range(1, WORKERS + 1)]
    for worker in workers:
        worker.start()
    while len(squares) < WORKERS:
        rclpy.spin_once(node)
    for worker in workers:
        worker.join()
    node.get_logger().info(f"By {method}: {sorted(squares)}")
    node.destroy_node()
    rclpy.shutdown()


if __name__ == "__main__":
    main(*sys.argv[1:] or ["spawn"])
