"""Names, parameters and remappings of nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

import launch_ros.utilities.evaluate_parameters
import launch_ros.utilities.normalize_parameters
import launch_ros.utilities.normalize_remap_rule
import launch_ros.utilities.to_parameters_list
from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameters as evaluate_parameters
from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameters as normalize_parameters
from tfloom.launch.ros.utilities.normalize_remap_rule import normalize_remap_rule as normalize_remap_rule
from tfloom.launch.ros.utilities.to_parameters_list import to_parameters_list as to_parameters_list

__all__ = [
    "add_node_name",
    "evaluate_parameters",
    "get_node_name_count",
    "is_namespace_absolute",
    "is_root_namespace",
    "make_namespace_absolute",
    "normalize_parameters",
    "normalize_remap_rule",
    "normalize_remap_rules",
    "prefix_namespace",
    "to_parameters_list",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_ros.utilities import namespace_utils as namespace_utils
    from launch_ros.utilities import plugin_support as plugin_support
    from launch_ros.utilities import track_node_names as track_node_names
    from tfloom.launch.ros.utilities.namespace_utils import is_namespace_absolute as is_namespace_absolute
    from tfloom.launch.ros.utilities.namespace_utils import is_root_namespace as is_root_namespace
    from tfloom.launch.ros.utilities.namespace_utils import make_namespace_absolute as make_namespace_absolute
    from tfloom.launch.ros.utilities.namespace_utils import prefix_namespace as prefix_namespace
    from tfloom.launch.ros.utilities.normalize_remap_rule import normalize_remap_rules as normalize_remap_rules
    from tfloom.launch.ros.utilities.track_node_names import add_node_name as add_node_name
    from tfloom.launch.ros.utilities.track_node_names import get_node_name_count as get_node_name_count
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        add_node_name="tfloom.launch.ros.utilities.track_node_names",
        get_node_name_count="tfloom.launch.ros.utilities.track_node_names",
        is_namespace_absolute="tfloom.launch.ros.utilities.namespace_utils",
        is_root_namespace="tfloom.launch.ros.utilities.namespace_utils",
        make_namespace_absolute="tfloom.launch.ros.utilities.namespace_utils",
        namespace_utils="launch_ros.utilities",
        normalize_remap_rules="tfloom.launch.ros.utilities.normalize_remap_rule",
        plugin_support="launch_ros.utilities",
        prefix_namespace="tfloom.launch.ros.utilities.namespace_utils",
        track_node_names="launch_ros.utilities",
    )
