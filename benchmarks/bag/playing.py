"""Play bags of different sizes in a process, and print its memory: it must not grow with the bag."""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

from benchmarks.bag import made
from benchmarks.domain import DOMAIN_ID
from tfloom.bag.values import Topic
from tfloom.bag.writing.bag_writer import BagWriter

PERIOD_NS = 10_000_000
PLAY = """
import resource, sys
from tfloom.cli.main import main
exit_code = main(["bag", "play", sys.argv[1], "--rate", sys.argv[2], "--disable-keyboard-controls"])
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024)
raise SystemExit(exit_code)
"""


def write(folder: Path, size_mb: int) -> None:
    """Write a bag of messages of a megabyte."""
    writer = BagWriter(folder)
    channel = writer.add_topic(Topic("/image", "std_msgs/msg/UInt8MultiArray"))
    message = b"\0\1\0\0" + bytes(made.IMAGE - 4)
    for number in range(size_mb):
        stamp_ns = made.START + number * PERIOD_NS
        writer.push(channel, message, stamp_ns, stamp_ns)
    writer.close()


def main(words: list[str]) -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--sizes", type=int, nargs="+", default=[50, 500, 2000], help="sizes of the bags [MiB]"
    )
    parser.add_argument("--folder", type=Path, help="where the bags are written (default: a temporary one)")
    args = parser.parse_args(words)
    environment = os.environ | {"ROS_DOMAIN_ID": str(DOMAIN_ID)}
    print("\nmemory of `bag play`, by the size of the bag:")
    with TemporaryDirectory(dir=args.folder) as folder:
        for size_mb in args.sizes:
            path = Path(folder) / f"bag_{size_mb}"
            write(path, size_mb)
            start = perf_counter()
            player = subprocess.run(
                [sys.executable, "-c", PLAY, str(path), "20"],
                env=environment,
                capture_output=True,
                text=True,
                check=True,
                timeout=600.0,
            )
            print(f"  {size_mb:>5} MiB: {int(player.stdout):>4} MiB, {perf_counter() - start:.1f} s")
