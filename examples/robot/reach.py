"""Compute where an arm's tool gets at random positions of its joints, all at once, and print how far it reaches.

python examples/robot/reach.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tfloom.robot.model import RobotModel
from tfloom.tf2.buffer import Buffer

URDF = Path(__file__).with_name("arm.urdf")
COUNT = 100_000


def main() -> None:
    arm = RobotModel.from_urdf(URDF)
    limits = {name: arm.description.joints[name].limit for name in arm.variables}
    random = np.random.default_rng(1)
    positions = np.column_stack(
        [
            random.uniform(*((-np.pi, np.pi) if limit is None else (limit.lower, limit.upper)), COUNT)
            for limit in limits.values()
        ]
    )
    poses = arm.forward(positions)  # (N, links, 7)
    tool = poses[:, arm.links.index("tool"), :3]
    distances = np.linalg.norm(tool, axis=1)
    print(f"{COUNT} positions of {', '.join(arm.variables)}")
    print(f"the tool is {distances.min():.3f} m to {distances.max():.3f} m from the base")
    print(f"and at most {tool[:, 2].max():.3f} m high")

    buffer = Buffer()
    stamps_ns = np.arange(1, 101) * 10_000_000  # the first hundred, at 100 Hz
    arm.store(buffer, stamps_ns, positions[:100])
    print(buffer.lookup("base_link", "tool", 505_000_000))


if __name__ == "__main__":
    main()
