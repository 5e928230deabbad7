"""Transform PointCloud2; importing this module registers it for `Buffer.transform`."""

from tfloom.tf2_ros.point_cloud import do_transform_cloud, transform_points

__all__ = ["do_transform_cloud", "transform_points"]
