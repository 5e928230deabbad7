"""Convert PointCloud2 to numpy arrays and back."""

from typing import TYPE_CHECKING

from tfloom.interfaces.sensor_msgs.msg import PointCloud2 as PointCloud2
from tfloom.interfaces.sensor_msgs.msg import PointField as PointField
from tfloom.interfaces.std_msgs.msg import Header as Header
from tfloom.tf2_ros.point_cloud2 import *

if TYPE_CHECKING:
    from tfloom.tf2_ros.numpy_compat import structured_to_unstructured as structured_to_unstructured
    from tfloom.tf2_ros.numpy_compat import unstructured_to_structured as unstructured_to_structured
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        structured_to_unstructured="tfloom.tf2_ros.numpy_compat",
        unstructured_to_structured="tfloom.tf2_ros.numpy_compat",
    )
