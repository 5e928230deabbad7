"""Tools that show frames."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tf2_tools import view_frames as view_frames
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("tf2_tools")
