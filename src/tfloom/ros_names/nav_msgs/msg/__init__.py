"""The messages of nav_msgs."""

from tfloom.interfaces.nav_msgs.msg import *
from tfloom.interfaces.nav_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from nav_msgs.msg import _grid_cells as _grid_cells
    from nav_msgs.msg import _map_meta_data as _map_meta_data
    from nav_msgs.msg import _occupancy_grid as _occupancy_grid
    from nav_msgs.msg import _odometry as _odometry
    from nav_msgs.msg import _path as _path
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("nav_msgs.msg")
