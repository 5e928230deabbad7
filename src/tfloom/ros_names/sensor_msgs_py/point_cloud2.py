"""PointCloud2 in numpy's hands."""

from tfloom.interfaces.sensor_msgs.msg import PointCloud2, PointField
from tfloom.tf2_ros.point_cloud2 import *
from tfloom.tf2_ros.point_cloud2 import __all__
