"""The interfaces of map_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from map_msgs import msg as msg
    from map_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("map_msgs")
