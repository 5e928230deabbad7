"""Folders of packages as substitutions: `$(find-pkg-prefix NAME)` and `$(find-pkg-share NAME)`."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.frontend.expose import expose_substitution as expose_substitution
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.substitutions.find_package import FindPackage as FindPackage
    from tfloom.launch.ros.substitutions.find_package import FindPackagePrefix as FindPackagePrefix
    from tfloom.launch.ros.substitutions.find_package import FindPackageShare as FindPackageShare
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
    from tfloom.workspace.ament import get_package_prefix as get_package_prefix
    from tfloom.workspace.ament import get_package_share_directory as get_package_share_directory
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        FindPackage="tfloom.launch.ros.substitutions.find_package",
        FindPackagePrefix="tfloom.launch.ros.substitutions.find_package",
        FindPackageShare="tfloom.launch.ros.substitutions.find_package",
        LaunchContext="tfloom.launch.launch_context",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
        expose_substitution="tfloom.launch.frontend.expose",
        get_package_prefix="tfloom.workspace.ament",
        get_package_share_directory="tfloom.workspace.ament",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
    )
