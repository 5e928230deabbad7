"""Open a graph while the system has room for N more threads; then again, while it has room for all.

Prints what the first attempt raised, one line, or `worked`; how many threads were refused; and `worked` for the second.
"""

from __future__ import annotations

import ctypes
import sys
import threading

from tfloom.interfaces.std_msgs.msg import Int32
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import MultiThreadedExecutor
from tfloom.node.node import Node
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener


def attempt() -> None:
    """Send a message from one node to itself, with a listener of transforms and a pool of threads."""
    arrived = threading.Event()
    with Context() as context, MultiThreadedExecutor(2, context=context) as executor:
        node = Node("under_test", context=context)
        try:
            listener = TransformListener(Buffer(), node)
            publisher = node.create_publisher(Int32, "numbers", 10)
            node.create_subscription(Int32, "numbers", lambda _: arrived.set(), 10)
            executor.add_node(node)
            while not arrived.is_set():
                publisher.publish(Int32())
                executor.spin_once(timeout_sec=0.05)
            listener.unregister()
        finally:
            node.destroy_node()


control = ctypes.CDLL(None)
control.limit_threads(int(sys.argv[1]))
try:
    attempt()
    print("worked", flush=True)
except Exception as error:  # noqa: BLE001  # printed
    print(f"{type(error).__name__}: {error}", flush=True)
print(control.refused_threads(), flush=True)
control.limit_threads(-1)
attempt()
print("worked", flush=True)
