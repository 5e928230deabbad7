"""Arms with any number of joints, as URDF."""

from __future__ import annotations

JOINTS = 50


def arm(joints: int = JOINTS) -> str:
    """Return a chain of revolute joints, `joint_0` and so on, about axes in turn."""
    parts = ['<robot name="arm">', '<link name="link_0"/>']
    for i in range(joints):
        axis = ("1 0 0", "0 1 0", "0 0 1")[i % 3]
        parts.append(
            f'<link name="link_{i + 1}"/><joint name="joint_{i}" type="continuous"><parent link="link_{i}"/>'
            f'<child link="link_{i + 1}"/><origin xyz="0.1 0 0.2" rpy="0.1 0.2 0.3"/><axis xyz="{axis}"/></joint>'
        )
    return "".join([*parts, "</robot>"])


def joint_names(joints: int = JOINTS) -> list[str]:
    """Return the names of its joints, in order from the root."""
    return [f"joint_{i}" for i in range(joints)]
