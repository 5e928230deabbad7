"""The messages of rmw_dds_common."""

from tfloom.interfaces.rmw_dds_common.msg import *
from tfloom.interfaces.rmw_dds_common.msg import __all__
