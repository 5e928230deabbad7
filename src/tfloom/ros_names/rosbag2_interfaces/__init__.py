"""The interfaces of rosbag2_interfaces."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rosbag2_interfaces import msg as msg
    from rosbag2_interfaces import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rosbag2_interfaces")
