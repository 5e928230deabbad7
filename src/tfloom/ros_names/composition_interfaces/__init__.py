"""The interfaces of composition_interfaces."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from composition_interfaces import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("composition_interfaces")
