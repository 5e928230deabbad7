"""The buffer and its exceptions, without a node."""

from typing import TYPE_CHECKING

from tfloom.ros_guard import claim

claim("tf2_py")

from tfloom.tf2.errors import *
from tfloom.tf2_ros.buffer_core import BufferCore as BufferCore

if TYPE_CHECKING:
    from tfloom.c_libraries import add_dll_directories_from_env as add_dll_directories_from_env
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        add_dll_directories_from_env="tfloom.c_libraries",
    )
