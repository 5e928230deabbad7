"""Measure encoding and decoding of TFMessage beside its peers, large arrays, construction and imports.

The peers run in turns. The result is the best of many turns, because other load on the machine only adds time.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from tempfile import TemporaryDirectory
from time import perf_counter

from benchmarks.rosidl.peers import PEERS
from tfloom.interfaces.geometry_msgs.msg import TransformStamped, Vector3
from tfloom.interfaces.sensor_msgs.msg import PointCloud2
from tfloom.rosidl import cdr

TURNS = 25
TURN_S = 0.01


def best(*calls: Callable[[], object]) -> list[float]:
    """Return the best time of each call [µs]; the calls run in turns."""
    times = [float("inf")] * len(calls)
    counts = [max(1, int(TURN_S / max(seconds(call, 1), 1e-7))) for call in calls]
    for _ in range(TURNS):
        for i, call in enumerate(calls):
            times[i] = min(times[i], seconds(call, counts[i]) / counts[i] * 1e6)
    return times


def seconds(call: Callable[[], object], count: int) -> float:
    start = perf_counter()
    for _ in range(count):
        call()
    return perf_counter() - start


def table(count: int) -> None:
    peers = [make(count) for make in PEERS]
    for peer in peers:
        if (
            bytes(peer.encode())[4:] != bytes(peers[0].encode())[4:]
        ):  # after the header, whose options may differ
            raise SystemExit(f"{peer.name} encodes other octets than {peers[0].name}")
    encode = best(*(peer.encode for peer in peers))
    decode = best(*(peer.decode for peer in peers))
    for peer, write, read in zip(peers, encode, decode, strict=True):
        ratios = f"{write / encode[0]:8.1f} x {read / decode[0]:8.1f} x"
        print(f"TFMessage x {count:<4} {peer.name:22} {write:10.2f} {read:10.2f}   {ratios}")


def import_ms(statement: str) -> float:
    """Return the time of a statement in a new interpreter with cached bytecode [ms], the best of some."""
    code = f"import time; start = time.perf_counter(); {statement}; print(time.perf_counter() - start)"
    with TemporaryDirectory() as bytecode:  # in an installed package, pip has compiled it
        environment = os.environ | {"PYTHONPYCACHEPREFIX": bytecode, "PYTHONDONTWRITEBYTECODE": ""}
        runs = [
            subprocess.run(
                [sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment
            )
            for _ in range(9)
        ]
    return min(float(run.stdout) for run in runs) * 1e3


def main() -> None:
    print(f"{'':16} {'':22} {'encode µs':>10} {'decode µs':>10}   slower than tfloom by")
    for count in (1, 10, 100):
        table(count)
    cloud = PointCloud2(data=bytes(1_000_000))
    data = cdr.encode(cloud)
    write, read, copy = best(
        lambda: cdr.encode(cloud), lambda: cdr.decode(PointCloud2, data), lambda: data[1:]
    )
    print(
        f"\nPointCloud2 of 1 MB: encode {write:.1f} µs, decode {read:.1f} µs (a copy of the bytes: {copy:.1f} µs)"
    )
    vector, stamped = best(lambda: Vector3(x=1.0, y=2.0, z=3.0), TransformStamped)
    print(f"construct: Vector3 {vector:.2f} µs, TransformStamped {stamped:.2f} µs")
    print(
        f"import geometry_msgs.msg: {import_ms('import tfloom.interfaces.geometry_msgs.msg'):.1f} ms",
        end=", ",
    )
    print(f"sensor_msgs.msg: {import_ms('import tfloom.interfaces.sensor_msgs.msg'):.1f} ms")


main()
