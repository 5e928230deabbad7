"""The parser of launch files in YAML."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.yaml.parser import Parser as Parser

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.utilities.typing_file_path import FilePath as FilePath
    from tfloom.launch.yaml.entity import Entity as Entity
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Entity="tfloom.launch.yaml.entity",
        FilePath="tfloom.launch.utilities.typing_file_path",
    )
