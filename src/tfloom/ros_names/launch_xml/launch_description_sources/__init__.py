"""Launch descriptions in XML files."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "XMLLaunchDescriptionSource",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_xml.launch_description_sources import xml_launch_description_source as xml_launch_description_source
    from tfloom.launch.xml.xml_launch_description_source import XMLLaunchDescriptionSource as XMLLaunchDescriptionSource
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        XMLLaunchDescriptionSource="tfloom.launch.xml.xml_launch_description_source",
        xml_launch_description_source="launch_xml.launch_description_sources",
    )
