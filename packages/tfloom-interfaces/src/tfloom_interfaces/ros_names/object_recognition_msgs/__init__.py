"""The interfaces of object_recognition_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from object_recognition_msgs import action as action
    from object_recognition_msgs import msg as msg
    from object_recognition_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("object_recognition_msgs")
