"""Fill a buffer from /tf and /tf_static."""

from tfloom.tf2_ros.transform_listener import *
from tfloom.tf2_ros.transform_listener import __all__
