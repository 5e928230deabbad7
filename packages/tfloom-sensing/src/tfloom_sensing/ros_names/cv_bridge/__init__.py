"""Between image messages and OpenCV's arrays."""

from tfloom.ros_guard import claim

claim("cv_bridge")

import cv_bridge.core
from tfloom_sensing.cv_bridge import CvBridge, CvBridgeError
from tfloom_sensing.cv_types import getCvType
from tfloom_sensing.image_display import cvtColorForDisplay

__all__ = ["CvBridge", "CvBridgeError", "cvtColorForDisplay", "getCvType"]
