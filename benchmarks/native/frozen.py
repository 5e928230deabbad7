"""Measure the gain of a frozen file: time to a process's first answer, and memory, beside inserting the same arrays.

`python -m benchmarks.native.frozen mapped|stored FOLDER` is one such process.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter

import numpy as np

from benchmarks.tf2.peers import fill
from benchmarks.tf2.trees import humanoid
from tfloom.tf2.buffer import Buffer

RATE_HZ = 1000
TURNS = 7


def own_memory() -> int:
    """Return the anonymous memory of the process (RssAnon) [bytes]."""
    for line in Path("/proc/self/status").read_text("ascii").splitlines():
        if line.startswith("RssAnon"):
            return int(line.split()[1]) * 1024
    raise RuntimeError("/proc/self/status has no RssAnon")


def start(how: str, folder: Path) -> None:
    """Print the time to the first answer [s], the memory used [bytes], and the answer."""
    tree = humanoid(1)
    before, begin = own_memory(), perf_counter()
    if how == "mapped":
        buffer = Buffer.map(folder / "frozen")
    else:
        buffer = Buffer()
        edges = json.loads((folder / "edges.json").read_text("utf-8"))
        stamps, positions, rotations = (np.load(folder / f"{name}.npy", mmap_mode="r") for name in "spr")
        for edge, position, rotation in zip(edges, positions, rotations, strict=True):
            buffer.set_many(*edge, stamps, position, rotation)
    found = buffer.lookup(tree.target_frame, tree.source_frame, 0).transform
    took = perf_counter() - begin
    print(json.dumps([took, own_memory() - before, [*found.translation, *found.rotation_xyzw]]))


def measure() -> dict[str, tuple[float, float]]:
    """Return the time [ms] and the memory [MB], each without and with a frozen file."""
    tree = humanoid(RATE_HZ)
    with TemporaryDirectory() as name:
        folder = Path(name)
        fill(tree).freeze(folder / "frozen")
        (folder / "edges.json").write_text(json.dumps(tree.edges), "utf-8")
        for key, array in zip("spr", (tree.stamps_ns, tree.positions, tree.rotations_xyzw), strict=True):
            np.save(folder / f"{key}.npy", array)
        times: dict[str, list[float]] = {"stored": [], "mapped": []}
        memory: dict[str, list[float]] = {"stored": [], "mapped": []}
        answers = []
        for _ in range(TURNS):
            for how in ("stored", "mapped"):
                command = [sys.executable, "-m", "benchmarks.native.frozen", how, name]
                done = subprocess.run(command, capture_output=True, text=True, check=True)
                took, size, answer = json.loads(done.stdout)
                times[how].append(took * 1e3)
                memory[how].append(size / 1e6)
                answers.append(answer)
    if any(answer != answers[0] for answer in answers):
        raise SystemExit("a frozen buffer answers otherwise than one that was stored")
    return {
        "start [ms]": (median(times["stored"]), median(times["mapped"])),
        "memory [MB]": (median(memory["stored"]), median(memory["mapped"])),
    }


if __name__ == "__main__":
    start(sys.argv[1], Path(sys.argv[2]))
