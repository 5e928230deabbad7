"""The services of composition_interfaces."""

from tfloom.interfaces.composition_interfaces.srv import *
from tfloom.interfaces.composition_interfaces.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from composition_interfaces.srv import _list_nodes as _list_nodes
    from composition_interfaces.srv import _load_node as _load_node
    from composition_interfaces.srv import _unload_node as _unload_node
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("composition_interfaces.srv")
