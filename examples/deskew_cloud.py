"""Deskew a cloud from arrays: a lidar turns while its robot drives, with and without correction for the drive.

Run it with `python examples/deskew_cloud.py`; with matplotlib installed, `--plot deskew.png` draws both clouds, and
each point's distance from the walls.
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
    """Store odom_from_base at 200 Hz (8 m/s ahead on a curve of 1.5 rad/s), and the lidar's mounting position."""
    seconds = np.arange(-20, 41) / 200
    yaw = 1.5 * seconds
    radius = 8 / 1.5
    positions = np.stack((radius * np.sin(yaw), radius * (1 - np.cos(yaw)), np.zeros_like(yaw)), axis=1)
    rotations = np.stack((0 * yaw, 0 * yaw, np.sin(yaw / 2), np.cos(yaw / 2)), axis=1)
    buffer.set_many("odom", "base", START_NS + (seconds * SECOND).astype(np.int64), positions, rotations)
    buffer.set("base", "lidar", 0, (0.5, 0.0, 0.8), (0, 0, 0, 1), static=True)


def sweep(buffer: Buffer) -> tuple[np.ndarray, np.ndarray]:
    """Return the lidar's measurements of a room of 20 m by 12 m: points (N, 3) in the lidar, and a stamp for each."""
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


def off_the_walls(points: np.ndarray) -> np.ndarray:
    """Return the distance of each point in odom from the nearest wall [m]."""
    return np.abs(np.stack((10 - np.abs(points[:, 0]), 6 - np.abs(points[:, 1])))).min(axis=0)


def plot(buffer: Buffer, stamps: np.ndarray, clouds: dict[str, np.ndarray], path: str) -> None:
    """Draw the clouds from above with the path of the lidar, and each point's error over the sweep."""
    from matplotlib import pyplot as plt

    figure, (room, errors) = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
    for label, cloud in clouds.items():
        room.plot(cloud[:, 0], cloud[:, 1], ".", markersize=1.5, label=label)
        errors.plot((stamps - START_NS) / 1e6, off_the_walls(cloud), label=label)
    way = buffer.lookup_many("odom", "lidar", stamps).positions
    room.plot(way[:, 0], way[:, 1], "k-", linewidth=2, label="way of the lidar")
    room.plot(*way[-1, :2], "k>", markersize=7)
    room.set(
        xlabel="x in odom [m]", ylabel="y in odom [m]", title="A sweep of 0.1 s at 8 m/s", aspect="equal"
    )
    room.legend(markerscale=6, loc="center", bbox_to_anchor=(0.5, 0.3))
    errors.set(xlabel="time in the sweep [ms]", ylabel="distance from the nearest wall [m]")
    errors.grid(alpha=0.3)
    errors.legend()
    figure.savefig(path, dpi=100)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--plot", metavar="FILE", help="draw the clouds and their errors into this file")
    arguments = parser.parse_args()

    buffer = Buffer(None)
    drive(buffer)
    points, stamps = sweep(buffer)

    end_ns = int(stamps[-1])
    skewed = buffer.transform_points(points, "odom", "lidar", end_ns)
    deskewed = buffer.deskew(points, stamps, "odom", "lidar", "odom", end_ns)
    before, after = off_the_walls(skewed).mean(), off_the_walls(deskewed).mean()
    print(f"off the walls: {before:.3f} m as one moment, {after:.6f} m deskewed")

    if arguments.plot:
        plot(buffer, stamps, {"as one moment": skewed, "deskewed": deskewed}, arguments.plot)


if __name__ == "__main__":
    main()
