"""List the prefixes that are searched for packages."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.workspace.ament import AMENT_PREFIX_PATH_ENV_VAR as AMENT_PREFIX_PATH_ENV_VAR
from tfloom.workspace.ament import get_search_paths as get_search_paths
