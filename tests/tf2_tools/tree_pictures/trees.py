"""Trees of frames that the tests of pictures draw."""

from __future__ import annotations

import random

from tfloom.tf2_tools.tree_pictures.records import FrameRecord
from tfloom.tf2_tools.tree_pictures.tree import FrameTree, build_tree

NOW_S = 1795257550.785885
WIDTH_OF_A_ROBOT = 12
"""New frames get one of this many last frames as their parent."""


def record(child: str, parent: str, age_s: float = 0.004, rate: float = 62.514) -> FrameRecord:
    """Return a moving transform."""
    newest = NOW_S - age_s
    return FrameRecord(child, parent, "default_authority", rate, newest, newest - 5.016, 5.016)


def static(child: str, parent: str) -> FrameRecord:
    """Return a static transform."""
    return FrameRecord(child, parent, "default_authority", 10_000.0, 0.0, 0.0, 0.0)


def robot(frames: int) -> FrameTree:
    """Return a robot with this many frames, always the same."""
    dice = random.Random(1)
    records = [record("odom", "map", rate=20.0), record("base_link", "odom", rate=50.0)]
    publishers = {"odom": ["/amcl"], "base_link": ["/diff_drive_controller"]}
    links = ["base_link"]
    while len(records) + 1 < frames:
        part = dice.choice(["wheel", "arm_joint", "finger", "camera", "lidar", "imu"])
        child = f"{dice.choice(['left', 'right', 'front', 'rear'])}_{part}_{len(links)}_link"
        parent = dice.choice(links[-WIDTH_OF_A_ROBOT:])
        if dice.random() < 0.5:
            records.append(static(child, parent))
            publishers[child] = ["/robot_state_publisher"]
        else:
            age_s = 3.2 if dice.random() < 0.06 else dice.random() * 0.03
            records.append(record(child, parent, age_s, dice.choice([10.0, 50.0, 999.9])))
            publishers[child] = [dice.choice(["/controller_manager", "/sensors/calibration_node"])]
        links.append(child)
    return build_tree(records, NOW_S + 0.1, publishers)


def scripts() -> FrameTree:
    """Return several trees, one a loop, with names in other scripts, a long name, and a stale transform."""
    long_name = "very_long_namespace/with_a_robot_of_the_third_generation/and_its_camera_optical_frame/" * 2
    records = [
        *(record("a", "c"), record("b", "a"), static("c", "b")),
        *(record("лазер/передний", "база"), static("λέιζερ", "база"), record("კამერა", "база")),
        *(record("լազեր", "база", age_s=4.0), record(long_name, "base")),
    ]
    return build_tree(records, NOW_S + 0.1, {"λέιζερ": ["/οδηγός"], "კამერა": ["/камера", "/camera"]})


def fan(children: int) -> FrameTree:
    """Return one parent with many children."""
    return build_tree([record(f"f{i}", "root") for i in range(children)], NOW_S)


def chain(length: int) -> FrameTree:
    """Return frames that each have one child."""
    return build_tree([record(f"f{i + 1}", f"f{i}") for i in range(length)], NOW_S)
