"""Between image messages and OpenCV's arrays, with or without OpenCV."""

from tfloom.ros_guard import claim

claim("cv_bridge")

import cv_bridge.core
from tfloom.sensing.cv_bridge import CvBridge, CvBridgeError
from tfloom.sensing.cv_types import getCvType
from tfloom.sensing.image_display import cvtColorForDisplay

__all__ = ["CvBridge", "CvBridgeError", "cvtColorForDisplay", "getCvType"]
