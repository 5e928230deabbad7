"""Convert sensor_msgs to numpy arrays and back."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sensor_msgs_py import numpy_compat as numpy_compat
    from sensor_msgs_py import point_cloud2 as point_cloud2
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("sensor_msgs_py")
