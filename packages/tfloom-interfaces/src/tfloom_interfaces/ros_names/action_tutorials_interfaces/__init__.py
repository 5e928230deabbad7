"""The interfaces of action_tutorials_interfaces."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from action_tutorials_interfaces import action as action
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("action_tutorials_interfaces")
