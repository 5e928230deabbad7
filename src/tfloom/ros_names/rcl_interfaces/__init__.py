"""The interfaces of rcl_interfaces."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rcl_interfaces import msg as msg
    from rcl_interfaces import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rcl_interfaces")
