"""From arrays to a deskewed cloud: a lidar that turns while its robot drives, seen with and without the drive.

Run it with `python examples/deskew_cloud.py`; with matplotlib installed and `--plot deskew.png` it draws both.
"""

from __future__ import annotations

import argparse

import numpy as np

from tfloom.tf2.buffer import Buffer

SECOND = 1_000_000_000
START_NS = 100 * SECOND
SWEEP_S = 0.1
POINTS = 20_000


def drive(buffer: Buffer) -> None:
    """Store odom_from_base, 200 Hz: 8 m/s ahead on a curve of 1.5 rad/s; and where the lidar is mounted."""
    seconds = np.arange(-20, 41) / 200
    yaw = 1.5 * seconds
    radius = 8 / 1.5
    positions = np.stack((radius * np.sin(yaw), radius * (1 - np.cos(yaw)), np.zeros_like(yaw)), axis=1)
    rotations = np.stack((0 * yaw, 0 * yaw, np.sin(yaw / 2), np.cos(yaw / 2)), axis=1)
    buffer.set_many("odom", "base", START_NS + (seconds * SECOND).astype(np.int64), positions, rotations)
    buffer.set("base", "lidar", 0, (0.5, 0.0, 0.8), (0, 0, 0, 1), static=True)


def sweep(buffer: Buffer) -> tuple[np.ndarray, np.ndarray]:
    """Return what the lidar measures of the walls of a room, 20 m by 12 m: points (N, 3), and a stamp for each."""
    share = np.arange(POINTS) / POINTS
    stamps = START_NS + (share * SWEEP_S * SECOND).astype(np.int64)
    poses = buffer.lookup_many("odom", "lidar", stamps)
    yaw = 2 * np.arctan2(poses.rotations_xyzw[:, 2], poses.rotations_xyzw[:, 3])
    bearing = 2 * np.pi * share
    ahead = np.stack((np.cos(bearing + yaw), np.sin(bearing + yaw)), axis=1)
    corner = np.array([10.0, 6.0])
    with np.errstate(divide="ignore"):
        distance = ((np.copysign(corner, ahead) - poses.positions[:, :2]) / ahead).min(axis=1)
    points = np.stack((distance * np.cos(bearing), distance * np.sin(bearing), np.zeros(POINTS)), axis=1)
    return points.astype(np.float32), stamps


def error_m(points: np.ndarray) -> float:
    """Return how far points in odom are from the walls, in the mean [m]."""
    return float(np.abs(np.stack((10 - np.abs(points[:, 0]), 6 - np.abs(points[:, 1])))).min(axis=0).mean())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--plot", metavar="FILE", help="draw both clouds into this file")
    arguments = parser.parse_args()

    buffer = Buffer(None)
    drive(buffer)
    points, stamps = sweep(buffer)

    skewed = buffer.transform_points(points, "odom", "lidar", int(stamps[-1]))
    deskewed = buffer.deskew(points, stamps, "odom", "lidar", "odom", int(stamps[-1]))
    print(f"off the walls: {error_m(skewed):.3f} m as one moment, {error_m(deskewed):.6f} m deskewed")

    if arguments.plot:
        from matplotlib import pyplot as plt

        for cloud, label in ((skewed, "as one moment"), (deskewed, "deskewed")):
            plt.plot(cloud[:, 0], cloud[:, 1], ".", markersize=1, label=label)
        plt.axis("equal")
        plt.legend()
        plt.savefig(arguments.plot)


if __name__ == "__main__":
    main()
