"""One camera: image_geometry's PinholeCameraModel."""

from __future__ import annotations

import copy
import math
from collections.abc import Sequence
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.sensor_msgs.msg import CameraInfo, RegionOfInterest
from tfloom_sensing.old_names import old_matrix, old_name, old_property, old_value
from tfloom_sensing.opencv import load_opencv

__all__ = ["PinholeCameraModel", "mkmat"]

Array = NDArray[Any]
_Value = TypeVar("_Value")

_EQUIDISTANT = "equidistant"
"""The model of fisheye lenses, whose formula is another; source: sensor_msgs, distortion_models.hpp."""

_NUMBERS_OF_COEFFICIENTS = (0, 4, 5, 8, 12, 14)
_FISHEYE_COEFFICIENTS = 4


def mkmat(rows: int, cols: int, L: Any) -> Array:  # noqa: N803  # image_geometry's name
    """Return numbers as a matrix (rows, cols) of float64, filled up with zeros."""
    matrix = np.array(L, dtype=np.float64)
    matrix.resize((rows, cols))
    return matrix


def _given(value: _Value | None) -> _Value:
    if value is None:
        raise ValueError("there is no camera yet; call from_camera_info first")
    return value


class PinholeCameraModel:
    """The geometry of a camera and its rectified images, from a CameraInfo.

    Call `from_camera_info` first. Pixels are (u, v), column and row; points are in the camera's optical frame: x right,
    y down, z forward. Matrices are as in CameraInfo; K and P fit images with its binning and region of interest.
    """

    def __init__(self) -> None:
        self._k: Array | None = None
        self._d: Array | None = None
        self._distortion_model = ""
        self._r: Array | None = None
        self._p: Array | None = None
        self._full_k: Array | None = None
        self._full_p: Array | None = None
        self._width: int | None = None
        self._height: int | None = None
        self._binning_x: int | None = None
        self._binning_y: int | None = None
        self._raw_roi: RegionOfInterest | None = None
        self._tf_frame: str | None = None
        self._stamp: Time | None = None
        self._resolution: tuple[int, int] | None = None
        self.mapx: Array | None = None
        self.mapy: Array | None = None

    def from_camera_info(self, msg: CameraInfo) -> None:
        """Take the camera's parameters from a message."""
        self._full_k, self._full_p = mkmat(3, 3, msg.k), mkmat(3, 4, msg.p)
        self._d = mkmat(len(msg.d), 1, msg.d) if len(msg.d) else None
        self._distortion_model = msg.distortion_model
        self._r = mkmat(3, 3, msg.r)
        self._width, self._height = self._resolution = (msg.width, msg.height)
        self._binning_x, self._binning_y = max(1, msg.binning_x), max(1, msg.binning_y)
        self._raw_roi = copy.copy(msg.roi)
        if not any((msg.roi.x_offset, msg.roi.y_offset, msg.roi.width, msg.roi.height)):
            self._raw_roi.width, self._raw_roi.height = self._resolution  # zeros are the whole image
        self._tf_frame = msg.header.frame_id
        self._stamp = msg.header.stamp
        self._k = self._fit_to_image(self._full_k, msg.roi)
        self._p = self._fit_to_image(self._full_p, msg.roi)
        self.mapx = self.mapy = None

    def _fit_to_image(self, full: Array, roi: RegionOfInterest) -> Array:
        """Return a matrix of full resolution as that of images with this binning and region of interest."""
        matrix: Array = full.copy()
        for row, offset, binning in ((0, roi.x_offset, self._binning_x), (1, roi.y_offset, self._binning_y)):
            matrix[row, row] /= binning
            matrix[row, 2] = (matrix[row, 2] - offset) / binning
        return matrix

    def rectify_image(self, raw: Array, rectified: Array) -> None:
        """Write the rectified image of a raw one, by cubic interpolation.

        Args:
            raw: Image (rows, columns) or (rows, columns, channels).
            rectified: Array of the result: (height, width) or (height, width, channels) of the CameraInfo, of the same
                type.

        Raises:
            ValueError: `rectified` has another shape or type, the CameraInfo has a wrong number of distortion
                coefficients, or there is none yet.
            ImportError: OpenCV is not installed.
        """
        width, height = _given(self._resolution)
        wanted = (height, width, *raw.shape[2:])
        if rectified.shape != wanted or rectified.dtype != raw.dtype:
            raise ValueError(
                f"the rectified image of {raw.dtype} {raw.shape} is {raw.dtype} {wanted}, "
                f"not {rectified.dtype} {rectified.shape}"
            )
        opencv = load_opencv()
        if self.mapx is None or self.mapy is None:
            lens, k, d = self._lens()
            self.mapx, self.mapy = lens.initUndistortRectifyMap(
                k, d, _given(self._r), _given(self._p), (width, height), opencv.CV_32FC1
            )
        mapped = opencv.remap(np.ascontiguousarray(raw), self.mapx, self.mapy, opencv.INTER_CUBIC)
        rectified[...] = mapped.reshape(wanted)

    def rectify_point(self, uv_raw: Sequence[float]) -> Array:
        """Return a pixel of the raw image as a pixel (2,) of the rectified one.

        Raises:
            ValueError: the CameraInfo has a wrong number of distortion coefficients, or there is none yet.
            ImportError: OpenCV is not installed.
        """
        lens, k, d = self._lens()
        uv = np.array([[[uv_raw[0], uv_raw[1]]]], np.float64)
        rectified: Array = lens.undistortPoints(uv, k, d, R=_given(self._r), P=_given(self._p))[0, 0]
        return rectified

    def project_3d_to_pixel(self, point: Sequence[float]) -> tuple[float, float]:
        """Return the rectified pixel of a point (x, y, z) [m]; NaN at depth 0."""
        u, v, w = _given(self._p) @ np.array([point[0], point[1], point[2], 1.0])
        return (u / w, v / w) if w != 0 else (math.nan, math.nan)

    def project_pixel_to_3d_ray(self, uv: Sequence[float]) -> tuple[float, float, float]:
        """Return the unit vector (x, y, z) from the pinhole through a rectified pixel."""
        x = (uv[0] - self.cx()) / self.fx()
        y = (uv[1] - self.cy()) / self.fy()
        norm = math.sqrt(x * x + y * y + 1)
        return (x / norm, y / norm, 1.0 / norm)

    def get_delta_u(self, delta_x: float, z: float) -> float:
        """Return the width [px] of an object of width `delta_x` [m] at depth `z` [m]; infinite at depth 0."""
        return math.inf if z == 0 else self.fx() * delta_x / z

    def get_delta_v(self, delta_y: float, z: float) -> float:
        """Return the height [px] of an object of height `delta_y` [m] at depth `z` [m]; infinite at depth 0."""
        return math.inf if z == 0 else self.fy() * delta_y / z

    def get_delta_x(self, delta_u: float, z: float) -> float:
        """Return the width [m] of an object of width `delta_u` [px] at depth `z` [m]."""
        return z * delta_u / self.fx()

    def get_delta_y(self, delta_v: float, z: float) -> float:
        """Return the height [m] of an object of height `delta_v` [px] at depth `z` [m]."""
        return z * delta_v / self.fy()

    def full_resolution(self) -> tuple[int, int] | None:
        """Return width and height [px] of the camera's full images."""
        return self._resolution

    def intrinsic_matrix(self) -> Array | None:
        """Return K (3, 3): the camera matrix of raw images."""
        return self._k

    def distortion_coeffs(self) -> Array | None:
        """Return D (n, 1): the distortion coefficients; None if the CameraInfo has none."""
        return self._d

    def rotation_matrix(self) -> Array | None:
        """Return R (3, 3): the rotation from the camera to the rectified one."""
        return self._r

    def projection_matrix(self) -> Array | None:
        """Return P (3, 4): the projection matrix of rectified images."""
        return self._p

    def full_intrinsic_matrix(self) -> Array | None:
        """Return K (3, 3) at full resolution."""
        return self._full_k

    def full_projection_matrix(self) -> Array | None:
        """Return P (3, 4) at full resolution."""
        return self._full_p

    def cx(self) -> float:
        """Return the column of the optical axis [px]."""
        return float(_given(self._p)[0, 2])

    def cy(self) -> float:
        """Return the row of the optical axis [px]."""
        return float(_given(self._p)[1, 2])

    def fx(self) -> float:
        """Return the horizontal focal length [px]."""
        return float(_given(self._p)[0, 0])

    def fy(self) -> float:
        """Return the vertical focal length [px]."""
        return float(_given(self._p)[1, 1])

    def tx(self) -> float:
        """Return the horizontal translation of P: minus fx times the baseline of a right camera [px m]."""
        return float(_given(self._p)[0, 3])

    def ty(self) -> float:
        """Return the vertical translation of P [px m]."""
        return float(_given(self._p)[1, 3])

    def fov_x(self) -> float:
        """Return the horizontal field of view [rad] of the full width."""
        return 2 * math.atan(_given(self._width) / (2 * self.fx()))

    def fov_y(self) -> float:
        """Return the vertical field of view [rad] of the full height."""
        return 2 * math.atan(_given(self._height) / (2 * self.fy()))

    def get_tf_frame(self) -> str | None:
        """Return the camera's optical frame."""
        return self._tf_frame

    def _lens(self) -> tuple[Any, Array, Array | None]:
        """Return OpenCV's functions for the distortion model, K, and D as they take it.

        Raises:
            ValueError: there is a number of coefficients that the model does not have.
        """
        k, d = _given(self._k), self._d
        number = 0 if d is None else d.size
        if self._distortion_model != _EQUIDISTANT:
            if number not in _NUMBERS_OF_COEFFICIENTS:
                raise ValueError(f"a distortion has 4, 5, 8, 12 or 14 coefficients, or none, not {number}")
            return load_opencv(), k, d
        if number not in {0, _FISHEYE_COEFFICIENTS}:
            raise ValueError(f"an equidistant lens has {_FISHEYE_COEFFICIENTS} coefficients, not {number}")
        return load_opencv().fisheye, k, np.zeros(_FISHEYE_COEFFICIENTS) if d is None else d

    binning_x = old_value("binning_x", "_binning_x")
    binning_y = old_value("binning_y", "_binning_y")
    D = old_property("D", distortion_coeffs)
    full_K = old_property("full_K", full_intrinsic_matrix)
    full_P = old_property("full_P", full_projection_matrix)
    height = old_value("height", "_height")
    K = old_property("K", intrinsic_matrix)
    P = old_property("P", projection_matrix)
    R = old_property("R", rotation_matrix)
    raw_roi = old_value("raw_roi", "_raw_roi")
    stamp = old_value("stamp", "_stamp")
    tf_frame = old_value("tf_frame", "_tf_frame", "Please use the get_tf_frame() method.")
    width = old_value("width", "_width")
    distortionCoeffs = old_matrix("distortionCoeffs", distortion_coeffs)
    fovX = old_name("fovX", fov_x)
    fovY = old_name("fovY", fov_y)
    fromCameraInfo = old_name("fromCameraInfo", from_camera_info)
    fullIntrinsicMatrix = old_matrix("fullIntrinsicMatrix", full_intrinsic_matrix)
    fullProjectionMatrix = old_matrix("fullProjectionMatrix", full_projection_matrix)
    fullResolution = old_name("fullResolution", full_resolution)
    getDeltaU = old_name("getDeltaU", get_delta_u)
    getDeltaV = old_name("getDeltaV", get_delta_v)
    getDeltaX = old_name("getDeltaX", get_delta_x)
    getDeltaY = old_name("getDeltaY", get_delta_y)
    intrinsicMatrix = old_matrix("intrinsicMatrix", intrinsic_matrix)
    project3dToPixel = old_name("project3dToPixel", project_3d_to_pixel)
    projectionMatrix = old_matrix("projectionMatrix", projection_matrix)
    projectPixelTo3dRay = old_name("projectPixelTo3dRay", project_pixel_to_3d_ray)
    rectifyImage = old_name("rectifyImage", rectify_image)
    rectifyPoint = old_name("rectifyPoint", rectify_point)
    rotationMatrix = old_matrix("rotationMatrix", rotation_matrix)
    tfFrame = old_name("tfFrame", get_tf_frame)
    Tx = old_name("Tx", tx)
    Ty = old_name("Ty", ty)
