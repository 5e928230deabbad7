"""The interfaces of builtin_interfaces."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from builtin_interfaces import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("builtin_interfaces")
