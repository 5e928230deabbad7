"""Namespaces: absolute or not, and one under another."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.utilities.namespace_utils import OptionalText as OptionalText
from tfloom.launch.ros.utilities.namespace_utils import is_namespace_absolute as is_namespace_absolute
from tfloom.launch.ros.utilities.namespace_utils import is_root_namespace as is_root_namespace
from tfloom.launch.ros.utilities.namespace_utils import make_namespace_absolute as make_namespace_absolute
from tfloom.launch.ros.utilities.namespace_utils import prefix_namespace as prefix_namespace
