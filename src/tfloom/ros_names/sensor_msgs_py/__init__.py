"""Convert sensor_msgs to numpy arrays and back."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

TYPE_CHECKING = False
if TYPE_CHECKING:
    from sensor_msgs_py import numpy_compat as numpy_compat
    from sensor_msgs_py import point_cloud2 as point_cloud2
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        numpy_compat="sensor_msgs_py",
        point_cloud2="sensor_msgs_py",
    )
