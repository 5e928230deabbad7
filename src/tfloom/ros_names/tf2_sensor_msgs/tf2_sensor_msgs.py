"""Transform PointCloud2; importing this module registers it for `Buffer.transform`."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.geometry import from_msg_msg as from_msg_msg
from tfloom.tf2_ros.geometry import to_msg_msg as to_msg_msg
from tfloom.tf2_ros.point_cloud import do_transform_cloud as do_transform_cloud
from tfloom.tf2_ros.point_cloud import transform_points as transform_points

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.geometry_msgs.msg import Transform as Transform
    from tfloom.interfaces.geometry_msgs.msg import TransformStamped as TransformStamped
    from tfloom.interfaces.sensor_msgs.msg import PointCloud2 as PointCloud2
    from tfloom.interfaces.std_msgs.msg import Header as Header
    from tfloom.tf2_ros.numpy_compat import structured_to_unstructured as structured_to_unstructured
    from tfloom.tf2_ros.numpy_compat import unstructured_to_structured as unstructured_to_structured
    from tfloom.tf2_ros.point_cloud2 import create_cloud as create_cloud
    from tfloom.tf2_ros.point_cloud2 import read_points as read_points
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Header="tfloom.interfaces.std_msgs.msg",
        PointCloud2="tfloom.interfaces.sensor_msgs.msg",
        Transform="tfloom.interfaces.geometry_msgs.msg",
        TransformStamped="tfloom.interfaces.geometry_msgs.msg",
        create_cloud="tfloom.tf2_ros.point_cloud2",
        read_points="tfloom.tf2_ros.point_cloud2",
        structured_to_unstructured="tfloom.tf2_ros.numpy_compat",
        unstructured_to_structured="tfloom.tf2_ros.numpy_compat",
    )
