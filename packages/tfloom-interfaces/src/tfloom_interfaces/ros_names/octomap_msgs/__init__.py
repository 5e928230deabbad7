"""The interfaces of octomap_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from octomap_msgs import msg as msg
    from octomap_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("octomap_msgs")
