"""The interfaces of stereo_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from stereo_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("stereo_msgs")
