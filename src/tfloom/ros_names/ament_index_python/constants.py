"""Constants of the ament index: its environment variable and its folder."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.workspace.ament import AMENT_PREFIX_PATH_ENV_VAR as AMENT_PREFIX_PATH_ENV_VAR
from tfloom.workspace.ament import RESOURCE_INDEX_SUBFOLDER as RESOURCE_INDEX_SUBFOLDER
