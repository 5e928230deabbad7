"""Launch files in other languages than Python: their elements, the parser, and how a tag gets its action."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "Entity",
    "InvalidFrontendLaunchFileError",
    "Parser",
    "expose_action",
    "expose_substitution",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch.frontend import entity as entity
    from launch.frontend import expose as expose
    from launch.frontend import parse_substitution as parse_substitution
    from launch.frontend import parser as parser
    from launch.frontend import type_utils as type_utils
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.frontend.expose import expose_action as expose_action
    from tfloom.launch.frontend.expose import expose_substitution as expose_substitution
    from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError
    from tfloom.launch.frontend.parser import Parser as Parser
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Entity="tfloom.launch.frontend.entity",
        InvalidFrontendLaunchFileError="tfloom.launch.frontend.parser",
        Parser="tfloom.launch.frontend.parser",
        entity="launch.frontend",
        expose="launch.frontend",
        expose_action="tfloom.launch.frontend.expose",
        expose_substitution="tfloom.launch.frontend.expose",
        parse_substitution="launch.frontend",
        parser="launch.frontend",
        type_utils="launch.frontend",
    )
