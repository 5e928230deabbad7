"""Run Debian's python3-tf2, the core of ROS 1 Noetic, in the system's Python: see `debian_tf2.py`."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.tf2.trees import Tree

NAME = "Noetic's tf2"
PYTHON = "/usr/bin/python3"
LIMIT_S = 120


def measure_debian(trees: dict[str, Tree]) -> dict[str, Any]:
    """Return its times for each tree, and of inserts; or, as `absent`, the reason why there are none."""
    nothing: dict[str, Any] = {"trees": {}}
    if not Path(PYTHON).exists():
        return {**nothing, "absent": f"there is no {PYTHON}"}
    header = {
        where: {
            "count": len(tree.stamps_ns),
            "edges": tree.edges,
            "target": tree.target_frame,
            "source": tree.source_frame,
            "middle": tree.middle_ns,
        }
        for where, tree in trees.items()
    }
    parts = [json.dumps(header).encode(), b"\n"]
    for tree in trees.values():
        rows = np.concatenate((tree.positions, tree.rotations_xyzw), axis=2)
        parts += [tree.stamps_ns.tobytes(), rows.tobytes()]
    done = subprocess.run(
        [PYTHON, Path(__file__).parent / "debian_tf2.py"],
        input=b"".join(parts),
        capture_output=True,
        timeout=LIMIT_S,
        check=False,
    )
    if done.returncode != 0:
        return {**nothing, "absent": f"{PYTHON} failed: {done.stderr.decode().strip()}"}
    answer = json.loads(done.stdout)
    if "absent" in answer:
        return {**nothing, "absent": f"{PYTHON} has no python3-tf2 ({answer['absent']})"}
    return dict(answer)
