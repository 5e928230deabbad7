"""The velocities of a program that drives a robot: the last one is zero, however the program ends."""

from __future__ import annotations

import signal
import sys
import threading
from contextlib import suppress
from types import FrameType, TracebackType
from typing import TYPE_CHECKING, Any

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.node.client_library import spin
from tfloom.rmw.errors import WireError
from tfloom.rosidl.cdr import encode

if TYPE_CHECKING:
    from typing_extensions import Self

    from tfloom.node.endpoints.publisher import Publisher

__all__ = ["Velocities", "spin_driver"]

ACKNOWLEDGED_NS = 500_000_000
"""Longest wait until the last one has arrived."""


class Velocities:
    """Publishes velocities for the block, and zero at its end, if the last one was another.

    At its end also means Ctrl-C, SIGTERM, and SIGHUP of a terminal that is closed. Nothing can be sent after SIGKILL.

    Args:
        publisher: What publishes them.
    """

    def __init__(self, publisher: Publisher[Twist]) -> None:
        self._publisher = publisher
        self._moves = False

    def __enter__(self) -> Self:
        # Otherwise it would end the program at once. A program that ignores it, as by nohup, goes on to do so.
        self._handles_hangup = False
        if sys.platform != "win32" and threading.current_thread() is threading.main_thread():
            self._handles_hangup = signal.getsignal(signal.SIGHUP) is signal.SIG_DFL
            if self._handles_hangup:
                signal.signal(signal.SIGHUP, _exit_on_signal)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.stop()
        if sys.platform != "win32" and self._handles_hangup:
            signal.signal(signal.SIGHUP, signal.SIG_DFL)

    def publish(self, linear: float, angular: float) -> None:
        """Publish a velocity along x [m/s] and about z [rad/s]."""
        self._moves = bool(linear or angular)
        twist = Twist()
        twist.linear.x, twist.angular.z = linear, angular
        self._publisher.publish(twist)

    def stop(self) -> None:
        """Publish zero, if the last velocity was another one; also where a signal has shut the context down."""
        if not self._moves:
            return
        self._moves = False
        endpoint = self._publisher.wire_endpoint
        with suppress(WireError):  # the participant is closed
            endpoint.write(encode(Twist()))
            endpoint.wait_for_acks(ACKNOWLEDGED_NS)


def spin_driver(node: Any) -> None:
    """Spin a node until it is stopped; then stop the robot that it drives by its member `velocities`."""
    with node.velocities:
        spin(node)


def _exit_on_signal(number: int, _: FrameType | None) -> None:
    raise SystemExit(128 + number)
