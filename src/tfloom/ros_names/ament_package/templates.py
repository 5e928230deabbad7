"""Replace the variables of a template."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.workspace.templates import configure_file as configure_file
from tfloom.workspace.templates import configure_string as configure_string

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.workspace.templates import IS_WINDOWS as IS_WINDOWS
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        IS_WINDOWS="tfloom.workspace.templates",
    )
