"""Launch descriptions in YAML files."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "YAMLLaunchDescriptionSource",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_yaml.launch_description_sources import yaml_launch_description_source as yaml_launch_description_source
    from tfloom.launch.yaml.yaml_launch_description_source import YAMLLaunchDescriptionSource as YAMLLaunchDescriptionSource
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        YAMLLaunchDescriptionSource="tfloom.launch.yaml.yaml_launch_description_source",
        yaml_launch_description_source="launch_yaml.launch_description_sources",
    )
