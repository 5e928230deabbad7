"""Write bags, beside the writers of mcap and rosbags; and record what other processes publish over DDS."""

from __future__ import annotations

import argparse
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

from benchmarks.bag import made
from benchmarks.domain import DOMAIN_ID
from tfloom.bag import open_bag
from tfloom.bag.values import Topic
from tfloom.bag.writing.bag_writer import BagWriter, WriterSettings
from tfloom.bag.writing.definition_text import find_definition, hash_of

TYPE = "std_msgs/msg/String"
PUBLISHER = Path(__file__).with_name("publisher.py")
Write = Callable[[Path, list[bytes]], None]


def with_tfloom(storage_id: str) -> Write:
    def write(folder: Path, messages: list[bytes]) -> None:
        writer = BagWriter(folder, WriterSettings(storage_id))
        channel = writer.add_topic(Topic("/a", TYPE, "cdr", hash_of(TYPE), "", find_definition(TYPE)))
        for number, data in enumerate(messages):
            writer.push(channel, data, made.START + number, made.START + number)
        writer.close()

    return write


def with_mcap(folder: Path, messages: list[bytes]) -> None:
    from mcap.writer import CompressionType, Writer

    folder.mkdir()
    with (folder / "bag.mcap").open("wb") as file:
        writer = Writer(file, chunk_size=768 << 10, compression=CompressionType.NONE, enable_crcs=False)
        writer.start("ros2", "tfloom's benchmark")
        schema = writer.register_schema(TYPE, "ros2msg", b"string data")
        channel = writer.register_channel("/a", "cdr", schema)
        for number, data in enumerate(messages):
            writer.add_message(channel, made.START + number, data, made.START + number)
        writer.finish()


def with_rosbags(storage_id: str) -> Write:
    def write(folder: Path, messages: list[bytes]) -> None:
        from rosbags.rosbag2 import StoragePlugin, Writer
        from rosbags.typesys import Stores, get_typestore

        plugin = StoragePlugin.MCAP if storage_id == "mcap" else StoragePlugin.SQLITE3
        with Writer(folder, version=9, storage_plugin=plugin) as writer:
            connection = writer.add_connection("/a", TYPE, typestore=get_typestore(Stores.ROS2_JAZZY))
            for number, data in enumerate(messages):
                writer.write(connection, made.START + number, data)

    return write


WRITERS: dict[str, Write] = {
    "tfloom, mcap": with_tfloom("mcap"),
    "mcap's writer": with_mcap,
    "rosbags, mcap": with_rosbags("mcap"),
    "tfloom, sqlite3": with_tfloom("sqlite3"),
    "rosbags, sqlite3": with_rosbags("sqlite3"),
}


def best(write: Write, messages: list[bytes], place: Path, turns: int) -> float:
    """Return the shortest time in which a writer has written all messages [s]."""
    times = []
    for _ in range(turns):
        start = perf_counter()
        write(place / "bag", messages)
        times.append(perf_counter() - start)
        path = place / "bag" if (place / "bag" / "metadata.yaml").exists() else place / "bag" / "bag.mcap"
        with open_bag(path) as bag:
            if [message.data for message in bag.messages()] != messages:
                raise SystemExit(f"{path} does not hold what was written")
        shutil.rmtree(place / "bag")
    return min(times)


def compare_writers(place: Path, turns: int) -> None:
    """Print how fast each writer is, with small and with large messages."""
    for size, count in ((60, 50_000), (1 << 20, 200)):
        messages = [b"\0\1\0\0" + bytes(size - 4)] * count
        print(f"\n{count:,} messages of {size:,} bytes: µs a message, MB/s")
        for name, write in WRITERS.items():
            seconds = best(write, messages, place, turns)
            print(f"  {name:<18} {seconds / count * 1e6:>9.2f} {size * count / seconds / 1e6:>8.0f}")


def record(place: Path, publishers: int, rate: float, size: int, seconds: float) -> None:
    """Record what processes publish, and print how much of it arrived."""
    environment = os.environ | {"ROS_DOMAIN_ID": str(DOMAIN_ID)}
    folder = place / "recorded"
    topics = [f"/bench_{number}" for number in range(publishers)]
    words = [sys.executable, "-c", "from tfloom.cli.main import main; raise SystemExit(main())"]
    recorder = subprocess.Popen(
        [*words, "bag", "record", "--disable-keyboard-controls", "-o", str(folder), "--topics", *topics],
        env=environment,
        stderr=subprocess.DEVNULL,
    )
    try:
        running = [
            subprocess.Popen(
                [sys.executable, str(PUBLISHER), topic, str(rate / publishers), str(seconds), str(size)],
                env=environment,
                stdout=subprocess.PIPE,
                text=True,
            )
            for topic in topics
        ]
        sent = sum(int(process.communicate(timeout=seconds + 60.0)[0]) for process in running)
    finally:
        recorder.send_signal(signal.SIGINT)
        recorder.wait(60.0)
    with open_bag(folder) as bag:
        duration_s = (bag.end_ns - bag.start_ns) / 1e9
        print(
            f"  {publishers} publishers of {size:,} bytes: {sent:,} sent, {bag.message_count:,} recorded, "
            f"{bag.message_count / duration_s:,.0f} messages/s, {bag.message_count * size / duration_s / 1e6:.0f} MB/s"
        )
    shutil.rmtree(folder)


def main(words: list[str]) -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--turns", type=int, default=3, help="the shortest time of so many counts (default 3)"
    )
    parser.add_argument("--seconds", type=float, default=4.0, help="how long to publish (default 4)")
    parser.add_argument("--folder", type=Path, help="where the bags are written (default: a temporary one)")
    args = parser.parse_args(words)
    with TemporaryDirectory(dir=args.folder) as folder:
        compare_writers(Path(folder), args.turns)
        print("\n`bag record` of what other processes publish over DDS:")
        record(Path(folder), 2, 50_000.0, 32, args.seconds)
        record(Path(folder), 1, 200.0, 1_000_000, args.seconds)
