"""Two cameras side by side: image_geometry's StereoCameraModel."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tfloom.interfaces.sensor_msgs.msg import CameraInfo
from tfloom_sensing.old_names import old_name, old_value
from tfloom_sensing.pinhole_camera_model import PinholeCameraModel

__all__ = ["StereoCameraModel"]

Array = NDArray[Any]


class StereoCameraModel:
    """The geometry of two cameras whose images are rectified to one plane, with equal rows.

    Call `from_camera_info` first. Points are in the left camera's optical frame. A disparity is the left column of a
    point less the right one [px].
    """

    def __init__(self) -> None:
        self._left = PinholeCameraModel()
        self._right = PinholeCameraModel()
        self._q: Array | None = None

    def from_camera_info(self, left_msg: CameraInfo, right_msg: CameraInfo) -> None:
        """Take the cameras' parameters from messages.

        Raises:
            ValueError: the right camera's P has no baseline.
        """
        if not right_msg.p[3]:
            raise ValueError(
                "the right camera's P has no baseline: P[0, 3] is 0, minus fx times the baseline is wanted"
            )
        self._left.from_camera_info(left_msg)
        self._right.from_camera_info(right_msg)
        # (u, v, disparity, 1) to homogeneous (x, y, z, w), for cameras with the same cx.
        right = self._right
        baseline = -right.tx() / right.fx()
        self._q = np.zeros((4, 4))
        self._q[0, [0, 3]] = 1.0, -right.cx()
        self._q[1, [1, 3]] = 1.0, -right.cy()
        self._q[2, 3] = right.fx()
        self._q[3, 2] = 1.0 / baseline

    def get_tf_frame(self) -> str | None:
        """Return the left camera's optical frame."""
        return self._left.get_tf_frame()

    def project_3d_to_pixel(self, point: Sequence[float]) -> tuple[tuple[float, float], tuple[float, float]]:
        """Return the rectified pixels of a point (x, y, z) [m], the left and the right."""
        return self._left.project_3d_to_pixel(point), self._right.project_3d_to_pixel(point)

    def project_pixel_to_3d(self, left_uv: Sequence[float], disparity: float) -> tuple[float, float, float]:
        """Return the point (x, y, z) [m] at a rectified left pixel; zeros for a disparity of 0.

        Raises:
            ValueError: there are no CameraInfos yet.
        """
        if self._q is None:
            raise ValueError("there are no cameras yet; call from_camera_info first")
        x, y, z, w = self._q @ np.array([left_uv[0], left_uv[1], disparity, 1.0])
        return (x / w, y / w, z / w) if w != 0 else (0.0, 0.0, 0.0)

    def get_z(self, disparity: float) -> float:
        """Return the depth [m] of a point with a disparity [px]; infinite for 0."""
        return math.inf if disparity == 0 else -self._right.tx() / disparity

    def get_disparity(self, z: float) -> float:
        """Return the disparity [px] of a point at a depth [m]; infinite at depth 0."""
        return math.inf if z == 0 else -self._right.tx() / z

    def get_left_camera(self) -> PinholeCameraModel:
        """Return the left camera."""
        return self._left

    def get_right_camera(self) -> PinholeCameraModel:
        """Return the right camera."""
        return self._right

    left = old_value("left", "_left", "Please use the get_left_camera() method.")
    right = old_value("right", "_right", "Please use the get_right_camera() method.")
    Q = old_value("Q", "_q")
    fromCameraInfo = old_name("fromCameraInfo", from_camera_info)
    getDisparity = old_name("getDisparity", get_disparity)
    getZ = old_name("getZ", get_z)
    project3dToPixel = old_name("project3dToPixel", project_3d_to_pixel)
    projectPixelTo3d = old_name("projectPixelTo3d", project_pixel_to_3d)
    tfFrame = old_name("tfFrame", get_tf_frame)
