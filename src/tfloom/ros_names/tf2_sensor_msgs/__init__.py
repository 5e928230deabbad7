"""Transform PointCloud2; importing this module registers it for `Buffer.transform`."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.tf2_ros.point_cloud import do_transform_cloud as do_transform_cloud
from tfloom.tf2_ros.point_cloud import transform_points as transform_points

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tf2_sensor_msgs import tf2_sensor_msgs as tf2_sensor_msgs
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        tf2_sensor_msgs="tf2_sensor_msgs",
    )
