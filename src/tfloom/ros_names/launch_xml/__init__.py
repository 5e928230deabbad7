"""Launch files in XML."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "Entity",
    "Parser",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_xml import entity as entity
    from launch_xml import launch_description_sources as launch_description_sources
    from launch_xml import parser as parser
    from tfloom.launch.xml.entity import Entity as Entity
    from tfloom.launch.xml.parser import Parser as Parser
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Entity="tfloom.launch.xml.entity",
        Parser="tfloom.launch.xml.parser",
        entity="launch_xml",
        launch_description_sources="launch_xml",
        parser="launch_xml",
    )
