"""Parsers of launch files in other languages than Python."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError
from tfloom.launch.frontend.parser import Parser as Parser

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.frontend.parse_substitution import parse_if_substitutions as parse_if_substitutions
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        parse_if_substitutions="tfloom.launch.frontend.parse_substitution",
    )
