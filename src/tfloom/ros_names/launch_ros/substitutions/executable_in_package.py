"""A program of a package as a substitution: `$(exec-in-pkg PROGRAM PACKAGE)`."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.frontend.expose import expose_substitution as expose_substitution
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.substitutions.executable_in_package import (
        ExecutableInPackage as ExecutableInPackage,
    )
    from tfloom.launch.ros.substitutions.find_package import FindPackagePrefix as FindPackagePrefix
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure as SubstitutionFailure
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ExecutableInPackage="tfloom.launch.ros.substitutions.executable_in_package",
        FindPackagePrefix="tfloom.launch.ros.substitutions.find_package",
        LaunchContext="tfloom.launch.launch_context",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
        SubstitutionFailure="tfloom.launch.substitutions.substitution_failure",
        expose_substitution="tfloom.launch.frontend.expose",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
    )
