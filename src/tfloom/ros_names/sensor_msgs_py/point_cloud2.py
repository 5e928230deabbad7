"""Convert PointCloud2 to numpy arrays and back."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.point_cloud2 import DUMMY_FIELD_PREFIX as DUMMY_FIELD_PREFIX
from tfloom.tf2_ros.point_cloud2 import create_cloud as create_cloud
from tfloom.tf2_ros.point_cloud2 import create_cloud_xyz32 as create_cloud_xyz32
from tfloom.tf2_ros.point_cloud2 import dtype_from_fields as dtype_from_fields
from tfloom.tf2_ros.point_cloud2 import points_view as points_view
from tfloom.tf2_ros.point_cloud2 import read_points as read_points
from tfloom.tf2_ros.point_cloud2 import read_points_list as read_points_list
from tfloom.tf2_ros.point_cloud2 import read_points_numpy as read_points_numpy

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.sensor_msgs.msg import PointCloud2 as PointCloud2
    from tfloom.interfaces.sensor_msgs.msg import PointField as PointField
    from tfloom.interfaces.std_msgs.msg import Header as Header
    from tfloom.tf2_ros.numpy_compat import structured_to_unstructured as structured_to_unstructured
    from tfloom.tf2_ros.numpy_compat import unstructured_to_structured as unstructured_to_structured
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Header="tfloom.interfaces.std_msgs.msg",
        PointCloud2="tfloom.interfaces.sensor_msgs.msg",
        PointField="tfloom.interfaces.sensor_msgs.msg",
        structured_to_unstructured="tfloom.tf2_ros.numpy_compat",
        unstructured_to_structured="tfloom.tf2_ros.numpy_compat",
    )
