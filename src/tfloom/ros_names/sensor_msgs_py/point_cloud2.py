"""Convert PointCloud2 to numpy arrays and back."""

from tfloom.interfaces.sensor_msgs.msg import PointCloud2, PointField
from tfloom.tf2_ros.point_cloud2 import *
from tfloom.tf2_ros.point_cloud2 import __all__
