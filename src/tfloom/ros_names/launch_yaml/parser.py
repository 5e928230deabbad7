"""The parser of launch files in YAML."""

from typing import TYPE_CHECKING

from tfloom.launch.yaml.parser import *

if TYPE_CHECKING:
    from tfloom.launch.utilities.typing_file_path import FilePath as FilePath
    from tfloom.launch.yaml.entity import Entity as Entity
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        FilePath="tfloom.launch.utilities.typing_file_path",
        Entity="tfloom.launch.yaml.entity",
    )
