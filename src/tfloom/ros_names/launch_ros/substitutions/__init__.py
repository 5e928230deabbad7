"""Substitutions by packages and parameters."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "ExecutableInPackage",
    "FindPackage",
    "FindPackagePrefix",
    "FindPackageShare",
    "Parameter",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_ros.substitutions import executable_in_package as executable_in_package
    from launch_ros.substitutions import find_package as find_package
    from launch_ros.substitutions import parameter as parameter
    from tfloom.launch.ros.substitutions.executable_in_package import ExecutableInPackage as ExecutableInPackage
    from tfloom.launch.ros.substitutions.find_package import FindPackage as FindPackage
    from tfloom.launch.ros.substitutions.find_package import FindPackagePrefix as FindPackagePrefix
    from tfloom.launch.ros.substitutions.find_package import FindPackageShare as FindPackageShare
    from tfloom.launch.ros.substitutions.parameter import Parameter as Parameter
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ExecutableInPackage="tfloom.launch.ros.substitutions.executable_in_package",
        FindPackage="tfloom.launch.ros.substitutions.find_package",
        FindPackagePrefix="tfloom.launch.ros.substitutions.find_package",
        FindPackageShare="tfloom.launch.ros.substitutions.find_package",
        Parameter="tfloom.launch.ros.substitutions.parameter",
        executable_in_package="launch_ros.substitutions",
        find_package="launch_ros.substitutions",
        parameter="launch_ros.substitutions",
    )
