"""Messages for the tests of displays."""

from __future__ import annotations

from typing import Any

import numpy as np

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.geometry_msgs.msg import Point, Pose, Quaternion, Vector3, Wrench, WrenchStamped
from tfloom.interfaces.sensor_msgs.msg import CameraInfo, Image, JointState, PointCloud2, PointField
from tfloom.interfaces.std_msgs.msg import ColorRGBA, Header
from tfloom.interfaces.visualization_msgs.msg import Marker


def header(frame: str = "map", sec: int = 1) -> Header:
    return Header(stamp=Time(sec=sec), frame_id=frame)


def pose(
    x: float = 0.0, y: float = 0.0, z: float = 0.0, turn: tuple[float, ...] = (0.0, 0.0, 0.0, 1.0)
) -> Pose:
    return Pose(
        position=Point(x=x, y=y, z=z),
        orientation=Quaternion(x=turn[0], y=turn[1], z=turn[2], w=turn[3]),
    )


def wrench(
    force: tuple[float, float, float] = (0.0, 0.0, 0.0),
    torque: tuple[float, float, float] = (0.0, 0.0, 0.0),
    frame: str = "map",
    sec: int = 1,
) -> WrenchStamped:
    first, second = (Vector3(x=x, y=y, z=z) for x, y, z in (force, torque))
    return WrenchStamped(header=header(frame, sec), wrench=Wrench(force=first, torque=second))


def cloud(points: np.ndarray, frame: str = "map") -> PointCloud2:
    """Return a cloud of a structured array."""
    kinds = {"f4": PointField.FLOAT32, "f8": PointField.FLOAT64, "u4": PointField.UINT32}
    fields = [
        PointField(name=name, offset=offset, datatype=kinds[dtype.str[1:]], count=1)
        for name, (dtype, offset, *_) in points.dtype.fields.items()
    ]
    return PointCloud2(
        header=header(frame),
        height=1,
        width=len(points),
        fields=fields,
        point_step=points.dtype.itemsize,
        row_step=points.dtype.itemsize * len(points),
        data=points.tobytes(),
    )


def depth_image(depths: Any, encoding: str = "32FC1", frame: str = "map", sec: int = 1) -> Image:
    """Return an image of depths (H, W), in the encoding's unit; each row has 8 bytes more than its pixels."""
    table = np.asarray(depths, "<f4" if encoding == "32FC1" else "<u2")
    height, width = table.shape
    step = width * table.itemsize + 8
    data = b"".join(row.tobytes() + bytes([255] * 8) for row in table)
    return Image(
        header=header(frame, sec), height=height, width=width, step=step, encoding=encoding, data=data
    )


def camera_info(width: int, height: int, focal: float = 2.0, sec: int = 1) -> CameraInfo:
    """Return the info of a camera whose axis is at the pixel (1, 0); along y it has half the focal length."""
    k = [focal, 0, 1.0, 0, focal / 2.0, 0.0, 0, 0, 1]
    return CameraInfo(header=header("map", sec), width=width, height=height, k=k)


ARM = """<robot name="arm"><link name="map"/><link name="a"/><link name="b"/><link name="c"/>
<joint name="elbow" type="revolute"><parent link="map"/><child link="a"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="10" velocity="1"/></joint>
<joint name="rail" type="prismatic"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/>
<limit lower="-1" upper="1" effort="4" velocity="1"/></joint>
<joint name="wheel" type="continuous"><parent link="b"/><child link="c"/></joint></robot>"""
"""A joint that turns, one that slides, and one without a limit of its effort."""


def efforts(sec: int = 1, **of_joints: float) -> JointState:
    return JointState(header=header("", sec), name=list(of_joints), effort=list(of_joints.values()))


def marker(kind: int, number: int = 0, **fields: Any) -> Marker:
    defaults = {
        "header": header(),
        "ns": "test",
        "pose": pose(),
        "scale": Vector3(x=1.0, y=2.0, z=3.0),
        "color": ColorRGBA(r=1.0, g=0.5, b=0.0, a=1.0),
    }
    return Marker(type=kind, id=number, **(defaults | fields))
