"""The interfaces of example_interfaces."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from example_interfaces import action as action
    from example_interfaces import msg as msg
    from example_interfaces import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("example_interfaces")
