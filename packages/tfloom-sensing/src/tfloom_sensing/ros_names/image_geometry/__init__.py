"""Pixels to rays and back, by what CameraInfo says."""

from tfloom.ros_guard import claim

claim("image_geometry")

import image_geometry.cameramodels
from tfloom_sensing.pinhole_camera_model import PinholeCameraModel
from tfloom_sensing.stereo_camera_model import StereoCameraModel

__all__ = ["PinholeCameraModel", "StereoCameraModel"]
