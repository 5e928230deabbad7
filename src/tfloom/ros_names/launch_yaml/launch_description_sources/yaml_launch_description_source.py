"""Launch descriptions in YAML files."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.yaml.yaml_launch_description_source import YAMLLaunchDescriptionSource as YAMLLaunchDescriptionSource

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.launch_description_sources.frontend_launch_description_source import FrontendLaunchDescriptionSource as FrontendLaunchDescriptionSource
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.yaml.parser import Parser as Parser
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        FrontendLaunchDescriptionSource="tfloom.launch.launch_description_sources.frontend_launch_description_source",
        Parser="tfloom.launch.yaml.parser",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
    )
