"""Transform PointCloud2; importing this module registers it for `Buffer.transform`."""

from typing import TYPE_CHECKING

from tfloom.tf2_ros.point_cloud import do_transform_cloud as do_transform_cloud
from tfloom.tf2_ros.point_cloud import transform_points as transform_points

if TYPE_CHECKING:
    from tf2_sensor_msgs import tf2_sensor_msgs as tf2_sensor_msgs
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("tf2_sensor_msgs")
