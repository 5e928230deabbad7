"""Versions of the interface that extensions of `Node` are written for."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.ros.utilities.plugin_support import PluginException as PluginException
    from tfloom.launch.ros.utilities.plugin_support import (
        get_upper_bound_caret_version as get_upper_bound_caret_version,
    )
    from tfloom.launch.ros.utilities.plugin_support import satisfies_version as satisfies_version
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        PluginException="tfloom.launch.ros.utilities.plugin_support",
        get_upper_bound_caret_version="tfloom.launch.ros.utilities.plugin_support",
        satisfies_version="tfloom.launch.ros.utilities.plugin_support",
    )
