"""The messages of rmw_dds_common."""

from tfloom.interfaces.rmw_dds_common.msg import *
from tfloom.interfaces.rmw_dds_common.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rmw_dds_common.msg import _gid as _gid
    from rmw_dds_common.msg import _node_entities_info as _node_entities_info
    from rmw_dds_common.msg import _participant_entities_info as _participant_entities_info
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rmw_dds_common.msg")
