"""List the prefixes that are searched for packages."""

from tfloom.workspace.ament import (
    AMENT_PREFIX_PATH_ENV_VAR,
    get_search_paths,
)

__all__ = [
    "AMENT_PREFIX_PATH_ENV_VAR",
    "get_search_paths",
]
