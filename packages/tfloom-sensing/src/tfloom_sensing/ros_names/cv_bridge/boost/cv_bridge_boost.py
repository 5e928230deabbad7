"""Types and conversions, which are compiled in the original."""

from tfloom_sensing.cv_types import CV_MAT_CNWrap, CV_MAT_DEPTHWrap, getCvType
from tfloom_sensing.image_conversion import cvtColor2
from tfloom_sensing.image_display import cvtColorForDisplay

__all__ = ["CV_MAT_CNWrap", "CV_MAT_DEPTHWrap", "cvtColor2", "cvtColorForDisplay", "getCvType"]
