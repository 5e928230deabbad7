"""Transform PyKDL's values; importing this module registers them for `Buffer.transform`."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

import PyKDL as PyKDL
import tf2_ros as tf2_ros
from tfloom.interfaces.geometry_msgs.msg import PointStamped as PointStamped
from tfloom.tf2_ros.kdl import convert_vector as convert_vector
from tfloom.tf2_ros.kdl import do_transform_frame as do_transform_frame
from tfloom.tf2_ros.kdl import do_transform_twist as do_transform_twist
from tfloom.tf2_ros.kdl import do_transform_vector as do_transform_vector
from tfloom.tf2_ros.kdl import do_transform_wrench as do_transform_wrench
from tfloom.tf2_ros.kdl import from_msg_vector as from_msg_vector
from tfloom.tf2_ros.kdl import to_msg_vector as to_msg_vector
from tfloom.tf2_ros.kdl import transform_to_kdl as transform_to_kdl

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tf2_kdl import tf2_kdl as tf2_kdl
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        tf2_kdl="tf2_kdl",
    )
