"""The messages of visualization_msgs."""

from tfloom.interfaces.visualization_msgs.msg import *
from tfloom.interfaces.visualization_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from visualization_msgs.msg import _image_marker as _image_marker
    from visualization_msgs.msg import _interactive_marker as _interactive_marker
    from visualization_msgs.msg import _interactive_marker_control as _interactive_marker_control
    from visualization_msgs.msg import _interactive_marker_feedback as _interactive_marker_feedback
    from visualization_msgs.msg import _interactive_marker_init as _interactive_marker_init
    from visualization_msgs.msg import _interactive_marker_pose as _interactive_marker_pose
    from visualization_msgs.msg import _interactive_marker_update as _interactive_marker_update
    from visualization_msgs.msg import _marker as _marker
    from visualization_msgs.msg import _marker_array as _marker_array
    from visualization_msgs.msg import _menu_entry as _menu_entry
    from visualization_msgs.msg import _mesh_file as _mesh_file
    from visualization_msgs.msg import _uv_coordinate as _uv_coordinate
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("visualization_msgs.msg")
