"""Launch descriptions in XML files."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.xml.xml_launch_description_source import XMLLaunchDescriptionSource as XMLLaunchDescriptionSource

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.launch_description_sources.frontend_launch_description_source import FrontendLaunchDescriptionSource as FrontendLaunchDescriptionSource
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.xml.parser import Parser as Parser
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        FrontendLaunchDescriptionSource="tfloom.launch.launch_description_sources.frontend_launch_description_source",
        Parser="tfloom.launch.xml.parser",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
    )
