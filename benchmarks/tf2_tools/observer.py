"""Time of an observer for one transform, beside the sink of a transform listener, without a wire."""

from __future__ import annotations

import time
from collections.abc import Callable

from tfloom._native import Sink, TfObserver
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer

FRAMES, ROUNDS, TURNS = 100, 200, 7
START_NS, PERIOD_NS = 1_700_000_000_000_000_000, 1_000_000
GID = bytes(16)


def sinks() -> dict[str, Callable[[], Sink]]:
    """Return the sinks to measure, by name."""
    return {
        "transform listener": lambda: Buffer().tf_sink("peer", static=False),
        "observer": lambda: TfObserver().sink(False),
        "observer and buffer": lambda: TfObserver().sink(False, Buffer()),
    }


def messages(count: int) -> list[list[bytes]]:
    """Return the messages of each round, of `count` transforms each."""
    return [
        [
            _message(range(first, first + count), START_NS + number * PERIOD_NS)
            for first in range(0, FRAMES, count)
        ]
        for number in range(ROUNDS)
    ]


def _message(frames: range, stamp_ns: int) -> bytes:
    message = TFMessage()
    for frame in frames:
        transform = TransformStamped(child_frame_id=f"joint_{frame}")
        transform.header.frame_id = f"joint_{frame // 2}" if frame else "base"
        transform.header.stamp.sec, transform.header.stamp.nanosec = divmod(stamp_ns, 1_000_000_000)
        transform.transform.translation.x = stamp_ns % 97 / 10
        message.transforms.append(transform)
    return cdr.encode(message)


def fastest_us(make_sink: Callable[[], Sink], rounds: list[list[bytes]]) -> float:
    """Return the time of the fastest of some turns, for one transform [us]."""
    fastest_s = float("inf")
    for _ in range(TURNS):
        push = make_sink().push
        start_s = time.perf_counter()
        for number, messages in enumerate(rounds):
            received_ns = START_NS + number * PERIOD_NS + 100_000
            for data in messages:
                push(data, received_ns, received_ns, GID)
        fastest_s = min(fastest_s, time.perf_counter() - start_s)
    return fastest_s * 1e6 / (ROUNDS * FRAMES)


def main() -> None:
    """Print the times, of one message for all frames and of one message for each."""
    for count in (FRAMES, 1):
        rounds = messages(count)
        peer_us = 0.0
        for name, make_sink in sinks().items():
            time_us = fastest_us(make_sink, rounds)
            peer_us = peer_us or time_us
            print(
                f"{name:20} {time_us:6.3f} us for a transform, {count:3} in a message, "
                f"{time_us / peer_us:.2f} times the listener's"
            )


if __name__ == "__main__":
    main()
