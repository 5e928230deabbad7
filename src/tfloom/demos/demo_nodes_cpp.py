"""The programs of demo_nodes_cpp that tutorials and tests start; those that demo_nodes_py has alike are its own.

- talker: a greeting once a second
- add_two_ints_client, add_two_ints_client_async: the sum of 2 and 3, by a service; the waits are logged, too
"""

from __future__ import annotations

from functools import partial

from tfloom.demos.demo_nodes_py.services import call
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["Talker", "add_two_ints_client_async_main", "add_two_ints_client_main", "talker_main"]

PERIOD_S = 1.0
DEPTH = 7


class Talker(Node):
    """Publishes on chatter, with an increasing number."""

    def __init__(self) -> None:
        super().__init__("talker")
        self._count = 1
        self._publisher = self.create_publisher(String, "chatter", DEPTH)
        self.create_timer(PERIOD_S, self._publish)

    def _publish(self) -> None:
        message = String(data=f"Hello World: {self._count}")
        self._count += 1
        self.get_logger().info(f"Publishing: '{message.data}'")
        self._publisher.publish(message)


def talker_main(args: list[str] | None = None) -> int:
    """Publish until stopped; return the exit code."""
    expect_no_arguments("talker", "Publish a greeting on the topic chatter, once a second.", args)
    return run_program(args, lambda: spin(Talker()))


def add_two_ints_client_main(args: list[str] | None = None, *, name: str = "add_two_ints_client") -> int:
    """Call once, and end after the response; return the exit code."""
    expect_no_arguments(name, "Call the service add_two_ints with 2 and 3.", args)
    return run_program(args, partial(call, logs_waits=True))


def add_two_ints_client_async_main(args: list[str] | None = None) -> int:
    """Call once, and end after the response; return the exit code."""
    return add_two_ints_client_main(args, name="add_two_ints_client_async")
