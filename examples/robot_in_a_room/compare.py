"""Compare the odometry of a recorded drive, and its correction, with the truth: `compare.py RECORDING`."""

from __future__ import annotations

import sys

import numpy as np
from planar import of_pose

from tfloom.bag import BagError, frames, open_bag
from tfloom.tf2.errors import TransformException


def main(path: str, name: str = "") -> int:
    prefix = f"{name}/" if name else ""
    topic = f"/{prefix}ground_truth"
    try:
        with open_bag(path) as bag:
            if topic not in bag.topics:
                print(f"{path} has no {topic}: record it, too", file=sys.stderr)
                return 1
            truth = {
                stamp: of_pose(message.pose.pose)
                for stamp, (_, message) in zip(bag.stamps(topic).tolist(), bag.read(topic), strict=True)
            }
        buffer = frames(path)
        print(f"{'':16}{'way':>8}{'error, RMS':>12}{'largest':>10}{'at the end':>12}")
        for label, frame in (("odometry alone", "odom"), ("corrected", "map")):
            stamps = np.array(list(truth))
            way = buffer.trajectory(prefix + frame, prefix + "base_link", stamps, strict=False)
            true = np.array([truth[stamp][:2] for stamp in way.stamps_ns.tolist()]).reshape(-1, 2)
            errors = np.linalg.norm(way.positions[:, :2] - true, axis=1)
            if not len(errors):
                print(
                    f"{path}: {frame} and base_link are not connected at any time of {topic}",
                    file=sys.stderr,
                )
                return 1
            print(
                f"{label:16}{way.length_m:6.1f} m{np.sqrt(np.mean(errors**2)):10.3f} m"
                f"{errors.max():8.3f} m{errors[-1]:10.3f} m"
            )
    except (BagError, TransformException) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    if len(sys.argv) not in {2, 3}:
        sys.exit("usage: compare.py RECORDING [NAME]")
    sys.exit(main(*sys.argv[1:]))
