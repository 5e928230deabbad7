"""Publish a robot's frames at a rate, stamped now, until standard input ends: FRAMES RATE_HZ.

The message is encoded once; only its stamps and positions are written anew, so that the sender takes little of a core.
"""

from __future__ import annotations

import math
import struct
import sys
import threading
import time

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.serialization import serialize_message
from tf2_msgs.msg import TFMessage
from tf2_ros import TransformBroadcaster

STAMP_S = 1_111_111_111
"""A stamp by which the places of the stamps are found."""
X = 123.456


def robot(frames: int) -> TFMessage:
    """Return transforms of a chain of ten frames, from which the others hang."""
    message = TFMessage()
    for number in range(frames):
        transform = TransformStamped(child_frame_id=f"joint_{number}")
        transform.header.frame_id = f"joint_{(number - 1) % 10}" if number else "base"
        transform.header.stamp.sec = STAMP_S
        transform.transform.translation.x = X
        message.transforms.append(transform)
    return message


def places(data: bytearray, pattern: bytes) -> list[int]:
    """Return where a pattern is in the message."""
    found, at = [], data.find(pattern)
    while at >= 0:
        found.append(at)
        at = data.find(pattern, at + 1)
    return found


def main() -> None:
    frames, rate_hz = int(sys.argv[1]), float(sys.argv[2])
    rclpy.init()
    publisher = TransformBroadcaster(rclpy.create_node("robot")).pub_tf
    data = bytearray(serialize_message(robot(frames)))
    stamps, xs = places(data, struct.pack("<i", STAMP_S)), places(data, struct.pack("<d", X))
    if not len(stamps) == len(xs) == frames:
        raise ValueError("a pattern is in the message by chance")
    ended = threading.Event()
    threading.Thread(target=lambda: (sys.stdin.read(), ended.set()), daemon=True).start()
    begin, number = time.monotonic(), 0
    while not ended.is_set():
        now = time.time_ns()
        stamp, x = struct.pack("<iI", *divmod(now, 10**9)), struct.pack("<d", math.sin(now / 1e9))
        for at in stamps:
            data[at : at + 8] = stamp
        for at in xs:
            data[at : at + 8] = x
        publisher.publish(bytes(data))
        number += 1
        time.sleep(max(0.0, begin + number / rate_hz - time.monotonic()))


if __name__ == "__main__":
    main()
