"""One camera, and two side by side."""

from tfloom.sensing.pinhole_camera_model import PinholeCameraModel, mkmat
from tfloom.sensing.stereo_camera_model import StereoCameraModel

__all__ = ["PinholeCameraModel", "StereoCameraModel", "mkmat"]
