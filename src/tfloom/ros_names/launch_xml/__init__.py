"""Launch files in XML."""

from typing import TYPE_CHECKING

__all__ = ["Entity", "Parser"]

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
        entity="launch_xml",
        launch_description_sources="launch_xml",
        parser="launch_xml",
        Entity="tfloom.launch.xml.entity",
        Parser="tfloom.launch.xml.parser",
    )
