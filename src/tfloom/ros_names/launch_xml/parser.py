"""The parser of launch files in XML."""

from typing import TYPE_CHECKING

from tfloom.launch.xml.parser import *

if TYPE_CHECKING:
    from tfloom.launch.xml.entity import Entity as Entity
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Entity="tfloom.launch.xml.entity",
    )
