"""Transform PointCloud2; importing this module registers it for `Buffer.transform`."""

from tfloom.tf2_ros.point_cloud import do_transform_cloud, from_msg_msg, to_msg_msg, transform_points

__all__ = ["do_transform_cloud", "from_msg_msg", "to_msg_msg", "transform_points"]
