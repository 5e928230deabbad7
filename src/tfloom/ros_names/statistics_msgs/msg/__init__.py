"""The messages of statistics_msgs."""

from tfloom.interfaces.statistics_msgs.msg import *
from tfloom.interfaces.statistics_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from statistics_msgs.msg import _metrics_message as _metrics_message
    from statistics_msgs.msg import _statistic_data_point as _statistic_data_point
    from statistics_msgs.msg import _statistic_data_type as _statistic_data_type
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("statistics_msgs.msg")
