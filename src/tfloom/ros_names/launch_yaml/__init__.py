"""Launch files in YAML."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "Entity",
    "Parser",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_yaml import entity as entity
    from launch_yaml import launch_description_sources as launch_description_sources
    from launch_yaml import parser as parser
    from tfloom.launch.yaml.entity import Entity as Entity
    from tfloom.launch.yaml.parser import Parser as Parser
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Entity="tfloom.launch.yaml.entity",
        Parser="tfloom.launch.yaml.parser",
        entity="launch_yaml",
        launch_description_sources="launch_yaml",
        parser="launch_yaml",
    )
