"""Namespaces: absolute or not, and one under another."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.ros.utilities.namespace_utils import OptionalText as OptionalText
    from tfloom.launch.ros.utilities.namespace_utils import is_namespace_absolute as is_namespace_absolute
    from tfloom.launch.ros.utilities.namespace_utils import is_root_namespace as is_root_namespace
    from tfloom.launch.ros.utilities.namespace_utils import make_namespace_absolute as make_namespace_absolute
    from tfloom.launch.ros.utilities.namespace_utils import prefix_namespace as prefix_namespace
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        OptionalText="tfloom.launch.ros.utilities.namespace_utils",
        is_namespace_absolute="tfloom.launch.ros.utilities.namespace_utils",
        is_root_namespace="tfloom.launch.ros.utilities.namespace_utils",
        make_namespace_absolute="tfloom.launch.ros.utilities.namespace_utils",
        prefix_namespace="tfloom.launch.ros.utilities.namespace_utils",
    )
