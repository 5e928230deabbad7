"""The messages of vision_msgs."""

from tfloom_interfaces.interfaces.vision_msgs.msg import *
from tfloom_interfaces.interfaces.vision_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from vision_msgs.msg import _bounding_box2_d as _bounding_box2_d
    from vision_msgs.msg import _bounding_box2_d_array as _bounding_box2_d_array
    from vision_msgs.msg import _bounding_box3_d as _bounding_box3_d
    from vision_msgs.msg import _bounding_box3_d_array as _bounding_box3_d_array
    from vision_msgs.msg import _classification as _classification
    from vision_msgs.msg import _detection2_d as _detection2_d
    from vision_msgs.msg import _detection2_d_array as _detection2_d_array
    from vision_msgs.msg import _detection3_d as _detection3_d
    from vision_msgs.msg import _detection3_d_array as _detection3_d_array
    from vision_msgs.msg import _label_info as _label_info
    from vision_msgs.msg import _object_hypothesis as _object_hypothesis
    from vision_msgs.msg import _object_hypothesis_with_pose as _object_hypothesis_with_pose
    from vision_msgs.msg import _point2_d as _point2_d
    from vision_msgs.msg import _pose2_d as _pose2_d
    from vision_msgs.msg import _vision_class as _vision_class
    from vision_msgs.msg import _vision_info as _vision_info
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("vision_msgs.msg")
