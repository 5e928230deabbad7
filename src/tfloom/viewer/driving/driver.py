"""The velocities that pages ask for, each of which ends by itself."""

from __future__ import annotations

import math
import queue
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.geometry_msgs.msg import Twist, TwistStamped, Vector3
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.rmw.errors import WireError
from tfloom.rmw.qos import QoS
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr

if TYPE_CHECKING:
    from tfloom.rmw.base import NodeName, Participant, Writer

__all__ = ["SILENCE_S", "TWIST_TYPES", "Driver", "Wish", "run_driver"]

SILENCE_S = 0.5
"""A robot that is driven is stopped when its page says nothing for this time [s]."""
MATCH_S = 30.0
"""How long a stop is tried again whose writer has no subscription yet [s]."""
SETTLE_S = 5.0
"""How long a writer whose first word is a stop writes it again for each subscription that it finds [s]: a driver before
this one, which was killed, has moved a robot whose subscription may be found after those of others."""
CLOSE_S = 2.0
"""How long a stop is tried again at the end of a driver [s]."""
RETRY_S = 0.02
"""Period of these tries [s]."""
KEPT_S = 1.0
"""How long a writer is kept that no page uses any more, so that what it wrote last arrives [s]."""
TWIST_TYPES: dict[str, type[Any]] = {
    "geometry_msgs/msg/Twist": Twist,
    "geometry_msgs/msg/TwistStamped": TwistStamped,
}


class Wish(NamedTuple):
    """How a page wants a robot to move from now on; also a line of JSON, as a list."""

    page: str
    topic: str
    type_name: str
    """One of `TWIST_TYPES`."""
    linear: float
    """Along x [m/s]."""
    angular: float
    """About z [rad/s]."""
    told_s: float
    """When the page has said so [s, monotonic, which all processes of a machine share]."""
    stamp_ns: int
    """The same on the clock of stamps [ns since epoch]."""

    @property
    def moves(self) -> bool:
        """Whether the robot is to move."""
        return bool(self.linear or self.angular)

    def stopped(self) -> Wish:
        """Return the wish that ends this one, as of now."""
        now_s = time.monotonic()
        passed_ns = int((now_s - self.told_s) * 1e9)
        return self._replace(linear=0.0, angular=0.0, told_s=now_s, stamp_ns=self.stamp_ns + passed_ns)


class _Topic:
    """The writer of a topic, and who uses it."""

    def __init__(self, writer: Writer) -> None:
        self.writer = writer
        self.pages: set[str] = set()
        self.unused_s = math.inf
        """Since when no page uses it [s, monotonic]."""
        self.stop: Wish | None = None
        """A stop that waits for a subscription."""
        self.stop_end_s = math.inf
        """When that ends [s, monotonic]."""
        self.told_count = 0
        """How many subscriptions there were when it was written last; -1 if it was not."""
        self.settled_s = 0.0
        """From when on the subscriptions of robots that a killed driver has moved are known [s, monotonic]."""


class Driver:
    """Publishes velocities, and stops what is not told again in time. One thread may use it.

    Args:
        participant: The participant that writes.
        node: The node whose writers these are, which was added to the participant.
        refuse: Called with a page and the reason why its wish is not done.
    """

    def __init__(self, participant: Participant, node: NodeName, refuse: Callable[[str, str], None]) -> None:
        self._participant = participant
        self._node = node
        self._refuse = refuse
        self._topics: dict[tuple[str, str], _Topic] = {}
        """By name and type."""
        self._driven: dict[tuple[str, str], Wish] = {}
        """By page and topic: the last wish, where the robot moves by it."""

    def do(self, wish: Wish) -> None:
        """Publish a velocity, unless the page has said so too long ago."""
        key = wish.page, wish.topic
        if not wish.moves:
            self._driven.pop(key, None)
        elif time.monotonic() > wish.told_s + SILENCE_S:
            return
        else:
            self._driven[key] = wish  # before it is written: it is stopped whatever happens there
        try:
            topic = self._topic(wish)
            topic.pages.add(wish.page)
            topic.unused_s = math.inf
            self._write(topic, wish)
        except Exception as error:  # of one page: the others are driven on
            self._refuse(wish.page, _reason(error))

    def forget(self, page: str) -> None:
        """Stop what a page drives, because it was closed."""
        self._stop(wish for wish in self._driven.values() if wish.page == page)
        for topic in self._topics.values():
            topic.pages.discard(page)

    def step(self) -> float:
        """Stop what was not told again in time; return how long nothing else is to be done [s], maybe inf."""
        now_s = time.monotonic()
        self._stop(wish for wish in self._driven.values() if now_s > wish.told_s + SILENCE_S)
        due_s = min((wish.told_s + SILENCE_S for wish in self._driven.values()), default=math.inf)
        for key, topic in list(self._topics.items()):
            if topic.stop is not None:
                self._try_stop(topic, topic.stop)
                due_s = min(due_s, now_s + RETRY_S)
            elif not topic.pages:
                topic.unused_s = min(topic.unused_s, now_s)
                due_s = min(due_s, topic.unused_s + KEPT_S)
                if now_s > topic.unused_s + KEPT_S:
                    topic.writer.close()
                    del self._topics[key]
        return max(0.0, due_s - now_s)

    def close(self) -> None:
        """Stop what is driven, wait until that has arrived, and close the writers."""
        self._stop(self._driven.values())
        end_s = time.monotonic() + CLOSE_S
        for topic in self._topics.values():
            while topic.stop is not None and topic.told_count <= 0 and time.monotonic() < end_s:
                self._try_stop(topic, topic.stop)
                time.sleep(RETRY_S)
            with suppress(WireError):
                topic.writer.wait_for_acks(max(0, int((end_s - time.monotonic()) * 1e9)))
            topic.writer.close()
        self._topics.clear()

    def _stop(self, wishes: Iterable[Wish]) -> None:
        for wish in list(wishes):
            self.do(wish.stopped())

    def _topic(self, wish: Wish) -> _Topic:
        key = wish.topic, wish.type_name
        if key not in self._topics:
            named = topic_of(TWIST_TYPES[wish.type_name], wish.topic)
            opened = self._topics[key] = _Topic(self._participant.create_writer(self._node, named, QoS()))
            if not wish.moves:
                opened.settled_s = time.monotonic() + SETTLE_S
        return self._topics[key]

    def _write(self, topic: _Topic, wish: Wish) -> None:
        # A stop that the wire refuses, or that is written before a new writer knows the robot's subscription, is tried
        # again, because what moves the robot may have arrived: also from a driver before this one, which was killed.
        topic.stop = None if wish.moves else wish
        topic.stop_end_s = time.monotonic() + MATCH_S
        topic.told_count = -1
        self._publish(topic, wish)
        topic.told_count = topic.writer.matched_count()
        if topic.told_count > 0 and time.monotonic() > topic.settled_s:
            topic.stop = None

    def _try_stop(self, topic: _Topic, stop: Wish) -> None:
        """Write a stop again, when its writer has found a subscription."""
        now_s, count = time.monotonic(), topic.writer.matched_count()
        if count > topic.told_count:
            with suppress(WireError):
                self._publish(topic, stop)
                topic.told_count = count
        elif now_s > topic.stop_end_s or (count > 0 and now_s > topic.settled_s):
            topic.stop = None

    @staticmethod
    def _publish(topic: _Topic, wish: Wish) -> None:
        twist = Twist(linear=Vector3(x=wish.linear), angular=Vector3(z=wish.angular))
        if wish.type_name == "geometry_msgs/msg/Twist":
            topic.writer.write(cdr.encode(twist))
        else:
            sec, nanosec = divmod(wish.stamp_ns, 1_000_000_000)
            header = Header(stamp=Time(sec=sec, nanosec=nanosec))
            topic.writer.write(cdr.encode(TwistStamped(header=header, twist=twist)))


def _reason(error: Exception) -> str:
    return str(error) if isinstance(error, WireError) else f"{type(error).__name__}: {error}"


def run_driver(driver: Driver, commands: queue.SimpleQueue[Wish | str | None]) -> None:
    """Do commands until None comes: wishes, and the names of pages that were closed; then stop everything."""
    try:
        while True:
            wait_s = driver.step()
            try:
                command = commands.get(timeout=None if math.isinf(wait_s) else wait_s)
            except queue.Empty:
                continue
            if command is None:
                return
            if isinstance(command, str):
                driver.forget(command)
            else:
                driver.do(command)
    finally:
        driver.close()
