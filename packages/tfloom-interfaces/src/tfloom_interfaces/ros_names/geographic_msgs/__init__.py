"""The interfaces of geographic_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from geographic_msgs import msg as msg
    from geographic_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("geographic_msgs")
