"""The messages of shape_msgs."""

from tfloom.interfaces.shape_msgs.msg import *
from tfloom.interfaces.shape_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from shape_msgs.msg import _mesh as _mesh
    from shape_msgs.msg import _mesh_triangle as _mesh_triangle
    from shape_msgs.msg import _plane as _plane
    from shape_msgs.msg import _solid_primitive as _solid_primitive
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("shape_msgs.msg")
