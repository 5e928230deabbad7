"""Importing extension modules."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

import rpyutils.import_c_library
from tfloom.c_libraries import import_c_library as import_c_library

__all__ = [
    "add_dll_directories_from_env",
    "import_c_library",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rpyutils import add_dll_directories as add_dll_directories
    from tfloom.c_libraries import add_dll_directories_from_env as add_dll_directories_from_env
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        add_dll_directories="rpyutils",
        add_dll_directories_from_env="tfloom.c_libraries",
    )
