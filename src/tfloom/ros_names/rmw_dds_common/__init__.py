"""The interfaces of rmw_dds_common."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rmw_dds_common import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rmw_dds_common")
