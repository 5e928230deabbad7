"""The interfaces of std_srvs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from std_srvs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("std_srvs")
