"""The interfaces of turtlesim."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from turtlesim import action as action
    from turtlesim import msg as msg
    from turtlesim import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("turtlesim")
