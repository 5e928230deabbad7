"""The recordings that are measured: messages of transforms alone, or beside others that are large."""

from __future__ import annotations

import os
from pathlib import Path

from mcap.writer import CompressionType, Writer

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl.cdr import encode
from tfloom.rosidl.sources import find_source

START = 1_700_000_000_000_000_000
PERIOD_NS = 10_000_000
TRANSFORMS = 10
"""In each message, a chain from `map` to `link_9`."""
IMAGE = 1 << 20
"""Size of each other message [bytes]."""
COMPRESSIONS = {"none": CompressionType.NONE, "lz4": CompressionType.LZ4, "zstd": CompressionType.ZSTD}


def message(index: int) -> bytes:
    """Return a TFMessage, as its bytes."""
    stamp = START + index * PERIOD_NS
    transforms = []
    for link in range(TRANSFORMS):
        stamped = TransformStamped(
            header=Header(frame_id="map" if link == 0 else f"link_{link - 1}"), child_frame_id=f"link_{link}"
        )
        stamped.header.stamp.sec, stamped.header.stamp.nanosec = divmod(stamp, 1_000_000_000)
        stamped.transform.translation.x = index * 1e-3 + link
        stamped.transform.rotation.w = 1.0
        transforms.append(stamped)
    return encode(TFMessage(transforms=transforms))


def definition(name: str) -> bytes:
    """Return a type's definition with those of all types in it, as rosbag2 writes it."""
    texts, waiting = {}, [name]
    while waiting:
        type_name = waiting.pop()
        source = find_source(type_name)
        if source is None or type_name in texts:
            continue
        texts[type_name] = source.text
        package = type_name.partition("/")[0]
        for line in source.text.splitlines():
            base = line.partition("#")[0].strip().partition(" ")[0].partition("[")[0]
            if base and (base[0].isupper() or "/" in base):
                short = base if "/" in base else f"{package}/{base}"
                waiting.append(short.replace("/", "/msg/") if short.count("/") == 1 else short)
    parts = [texts.pop(name)]
    parts += [f"MSG: {type_name.replace('/msg/', '/')}\n{text}" for type_name, text in texts.items()]
    return ("\n" + "=" * 80 + "\n").join(parts).encode()


def write(path: Path, compression: str, count: int, other_mb: int = 0) -> Path:
    """Write a file with rosbag2's size of chunks.

    Args:
        path: The file.
        compression: A key of COMPRESSIONS.
        count: Number of TFMessages.
        other_mb: How much there is of another topic, in messages of a megabyte, one after some TFMessages each [MiB].
    """
    image = b"\0\1\0\0" + os.urandom(IMAGE // 2) + bytes(IMAGE // 2)
    every = max(1, count // other_mb) if other_mb else 0
    with path.open("wb") as file:
        writer = Writer(file, chunk_size=768 << 10, compression=COMPRESSIONS[compression])
        writer.start("ros2", "tfloom's benchmark")
        name = "tf2_msgs/msg/TFMessage"
        tf = writer.register_channel("/tf", "cdr", writer.register_schema(name, "ros2msg", definition(name)))
        other = writer.register_schema("std_msgs/msg/UInt8MultiArray", "ros2msg", b"")
        images = writer.register_channel("/image", "cdr", other)
        for index in range(count):
            stamp = START + index * PERIOD_NS
            writer.add_message(tf, stamp, message(index), stamp)
            if every and index % every == 0:
                writer.add_message(images, stamp + 1, image, stamp + 1)
        writer.finish()
    return path
