"""The interfaces of controller_manager_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from controller_manager_msgs import msg as msg
    from controller_manager_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("controller_manager_msgs")
