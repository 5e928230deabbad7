"""Launch descriptions in files of other languages than Python."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.launch_description_sources.frontend_launch_description_source import FrontendLaunchDescriptionSource as FrontendLaunchDescriptionSource
