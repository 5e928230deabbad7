"""Between image messages and OpenCV's arrays."""

from tfloom_sensing.cv_bridge import *
from tfloom_sensing.cv_bridge import __all__
