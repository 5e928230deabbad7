"""Fill a buffer from recordings, beside the peers that decode each message first."""

from __future__ import annotations

import argparse
from collections import deque
from collections.abc import Callable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter
from typing import Any

from benchmarks.bag import made
from tfloom.bag import frames
from tfloom.tf2.buffer import Buffer

TURNS = 5
FRAMES = ("map", f"link_{made.TRANSFORMS - 1}")


def with_tfloom(path: Path) -> Buffer:
    return frames(path)


def store(buffer: Buffer, message: Any) -> None:
    """Store a decoded message, whose fields are those of any Python ROS library."""
    for stamped in message.transforms:
        stamp, at, turn = stamped.header.stamp, stamped.transform.translation, stamped.transform.rotation
        stamp_ns = stamp.sec * 1_000_000_000 + stamp.nanosec
        buffer.set(
            stamped.header.frame_id,
            stamped.child_frame_id,
            stamp_ns,
            (at.x, at.y, at.z),
            (turn.x, turn.y, turn.z, turn.w),
        )


def messages_of_rosbags(path: Path) -> Iterator[Any]:
    from rosbags.highlevel import AnyReader
    from rosbags.typesys import Stores, get_typestore

    with AnyReader([path], default_typestore=get_typestore(Stores.ROS2_JAZZY)) as reader:
        wanted = [connection for connection in reader.connections if connection.topic == "/tf"]
        for connection, _, data in reader.messages(wanted):
            yield reader.deserialize(data, connection.msgtype)


def messages_of_mcap(path: Path) -> Iterator[Any]:
    from mcap.reader import make_reader
    from mcap_ros2.decoder import DecoderFactory

    with path.open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        for message in reader.iter_decoded_messages(topics=["/tf"]):
            yield message.decoded_message


def best(call: Callable[[], object], turns: int = TURNS) -> float:
    """Return the shortest time of a call [s]."""
    times = []
    for _ in range(turns):
        start = perf_counter()
        call()
        times.append(perf_counter() - start)
    return min(times)


def check(path: Path, count: int) -> None:
    """End if the peers and tfloom do not give the same transforms.

    Raises:
        SystemExit: they don't.
    """
    ours = with_tfloom(path)
    way = ours.trajectory(*FRAMES)
    for name, read in PEERS.items():
        theirs = Buffer(None)
        for message in read(path):
            store(theirs, message)
        other = theirs.trajectory(*FRAMES)
        if len(way.stamps_ns) != count or (way.positions != other.positions).any():
            raise SystemExit(f"{name} and tfloom give different transforms")


PEERS: dict[str, Callable[[Path], Iterator[Any]]] = {
    "rosbags, deserialized": messages_of_rosbags,
    "mcap and mcap-ros2-support": messages_of_mcap,
}


def run(folder: Path, count: int, other_mb: int) -> None:
    print(
        f"{count} TFMessages of {made.TRANSFORMS} transforms {'MB':>17} {'s':>8} {'µs/message':>11} {'ratio':>7}"
    )
    ours = 0.0
    for compression in made.COMPRESSIONS:
        path = made.write(folder / f"tf_{compression}.mcap", compression, count)
        check(path, count)
        seconds = best(lambda path=path: with_tfloom(path))  # type: ignore[misc]
        ours = ours or seconds
        row(f"tfloom, into a buffer, {compression}", path, seconds, count, seconds / ours)
        if compression == "none":
            for name, read in PEERS.items():
                taken = best(lambda read=read, path=path: deque(read(path), 1), 2)  # type: ignore[misc]
                row(f"{name}, into messages only", path, taken, count, taken / ours)
    for compression in ("none", "zstd"):
        path = made.write(folder / f"all_{compression}.mcap", compression, count, other_mb)
        share = count * len(made.message(0)) / path.stat().st_size
        path.read_bytes()  # into the system's cache, as for the others
        seconds = best(lambda path=path: with_tfloom(path))  # type: ignore[misc]
        row(f"tfloom, transforms are {share:.1%}, {compression}", path, seconds, count, seconds / ours)
        whole = best(lambda path=path: path.read_bytes(), 2)  # type: ignore[misc]
        row("  reading the whole file, no more", path, whole, count, whole / ours)
        path.unlink()


def row(name: str, path: Path, seconds: float, count: int, ratio: float) -> None:
    size = path.stat().st_size / 1e6
    print(f"{name:46} {size:7.0f} {seconds:8.3f} {seconds / count * 1e6:11.2f} {ratio:6.1f}x", flush=True)


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--messages", type=int, default=20_000, help="number of TFMessages")
    parser.add_argument("--other-mb", type=int, default=2_000, help="size of the topic beside them [MiB]")
    parser.add_argument(
        "--folder", type=Path, help="where to write the recordings; default: a temporary folder"
    )
    options = parser.parse_args(arguments)
    with TemporaryDirectory(prefix="tfloom-bag-", dir=options.folder) as folder:
        run(Path(folder), options.messages, options.other_mb)


if __name__ == "__main__":
    main()
