"""The classes of nav2_msgs/srv/ReloadDockDatabase, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import ReloadDockDatabase as ReloadDockDatabase
from tfloom_interfaces.interfaces.nav2_msgs.srv import ReloadDockDatabase_Event as ReloadDockDatabase_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import ReloadDockDatabase_Request as ReloadDockDatabase_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import ReloadDockDatabase_Response as ReloadDockDatabase_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ReloadDockDatabase
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ReloadDockDatabase_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ReloadDockDatabase_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ReloadDockDatabase_Response

__all__ = ["Metaclass_ReloadDockDatabase", "Metaclass_ReloadDockDatabase_Event", "Metaclass_ReloadDockDatabase_Request", "Metaclass_ReloadDockDatabase_Response", "ReloadDockDatabase", "ReloadDockDatabase_Event", "ReloadDockDatabase_Request", "ReloadDockDatabase_Response"]
