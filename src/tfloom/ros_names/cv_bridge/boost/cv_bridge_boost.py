"""Types and conversions, which are compiled in the original."""

from tfloom.sensing.cv_types import CV_MAT_CNWrap, CV_MAT_DEPTHWrap, getCvType
from tfloom.sensing.image_conversion import cvtColor2
from tfloom.sensing.image_display import cvtColorForDisplay

__all__ = ["CV_MAT_CNWrap", "CV_MAT_DEPTHWrap", "cvtColor2", "cvtColorForDisplay", "getCvType"]
