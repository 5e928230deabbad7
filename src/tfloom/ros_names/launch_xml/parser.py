"""The parser of launch files in XML."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.xml.parser import Parser as Parser

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.xml.entity import Entity as Entity
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Entity="tfloom.launch.xml.entity",
    )
