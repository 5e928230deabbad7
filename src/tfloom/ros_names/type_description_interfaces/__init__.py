"""The interfaces of type_description_interfaces."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from type_description_interfaces import msg as msg
    from type_description_interfaces import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("type_description_interfaces")
