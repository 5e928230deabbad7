"""Constants of the ament index: its environment variable and its folder."""

from tfloom.workspace.ament import (
    AMENT_PREFIX_PATH_ENV_VAR,
    RESOURCE_INDEX_SUBFOLDER,
)

__all__ = [
    "AMENT_PREFIX_PATH_ENV_VAR",
    "RESOURCE_INDEX_SUBFOLDER",
]
