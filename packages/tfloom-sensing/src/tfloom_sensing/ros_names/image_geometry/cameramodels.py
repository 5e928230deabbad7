"""One camera, and two side by side."""

from tfloom_sensing.pinhole_camera_model import PinholeCameraModel, mkmat
from tfloom_sensing.stereo_camera_model import StereoCameraModel

__all__ = ["PinholeCameraModel", "StereoCameraModel", "mkmat"]
