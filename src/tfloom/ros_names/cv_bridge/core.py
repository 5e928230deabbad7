"""Between image messages and OpenCV's arrays."""

from tfloom.sensing.cv_bridge import *
from tfloom.sensing.cv_bridge import __all__
