"""Versions of the interface that extensions of `Node` are written for."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.utilities.plugin_support import PluginException as PluginException
from tfloom.launch.ros.utilities.plugin_support import get_upper_bound_caret_version as get_upper_bound_caret_version
from tfloom.launch.ros.utilities.plugin_support import satisfies_version as satisfies_version
