"""Texts that are only known when the launch runs."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "AllSubstitution",
    "AndSubstitution",
    "AnonName",
    "AnySubstitution",
    "Command",
    "EnvironmentVariable",
    "EqualsSubstitution",
    "FileContent",
    "FindExecutable",
    "ForEachVar",
    "ForLoopIndex",
    "IfElseSubstitution",
    "LaunchConfiguration",
    "LaunchLogDir",
    "LocalSubstitution",
    "NotEqualsSubstitution",
    "NotSubstitution",
    "OrSubstitution",
    "PathJoinSubstitution",
    "PathSubstitution",
    "PythonExpression",
    "StringJoinSubstitution",
    "SubstitutionFailure",
    "TextSubstitution",
    "ThisLaunchFile",
    "ThisLaunchFileDir",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch.substitutions import anon_name as anon_name
    from launch.substitutions import boolean_substitution as boolean_substitution
    from launch.substitutions import command as command
    from launch.substitutions import environment_variable as environment_variable
    from launch.substitutions import equals_substitution as equals_substitution
    from launch.substitutions import file_content as file_content
    from launch.substitutions import find_executable as find_executable
    from launch.substitutions import for_loop_var as for_loop_var
    from launch.substitutions import if_else_substitution as if_else_substitution
    from launch.substitutions import launch_configuration as launch_configuration
    from launch.substitutions import launch_log_dir as launch_log_dir
    from launch.substitutions import local_substitution as local_substitution
    from launch.substitutions import not_equals_substitution as not_equals_substitution
    from launch.substitutions import path_join_substitution as path_join_substitution
    from launch.substitutions import python_expression as python_expression
    from launch.substitutions import string_join_substitution as string_join_substitution
    from launch.substitutions import substitution_failure as substitution_failure
    from launch.substitutions import text_substitution as text_substitution
    from launch.substitutions import this_launch_file as this_launch_file
    from launch.substitutions import this_launch_file_dir as this_launch_file_dir
    from tfloom.launch.substitutions.anon_name import AnonName as AnonName
    from tfloom.launch.substitutions.boolean_substitution import AllSubstitution as AllSubstitution
    from tfloom.launch.substitutions.boolean_substitution import AndSubstitution as AndSubstitution
    from tfloom.launch.substitutions.boolean_substitution import AnySubstitution as AnySubstitution
    from tfloom.launch.substitutions.boolean_substitution import NotSubstitution as NotSubstitution
    from tfloom.launch.substitutions.boolean_substitution import OrSubstitution as OrSubstitution
    from tfloom.launch.substitutions.command import Command as Command
    from tfloom.launch.substitutions.environment_variable import EnvironmentVariable as EnvironmentVariable
    from tfloom.launch.substitutions.equals_substitution import EqualsSubstitution as EqualsSubstitution
    from tfloom.launch.substitutions.file_content import FileContent as FileContent
    from tfloom.launch.substitutions.find_executable import FindExecutable as FindExecutable
    from tfloom.launch.substitutions.for_loop_var import ForEachVar as ForEachVar
    from tfloom.launch.substitutions.for_loop_var import ForLoopIndex as ForLoopIndex
    from tfloom.launch.substitutions.if_else_substitution import IfElseSubstitution as IfElseSubstitution
    from tfloom.launch.substitutions.launch_configuration import LaunchConfiguration as LaunchConfiguration
    from tfloom.launch.substitutions.launch_log_dir import LaunchLogDir as LaunchLogDir
    from tfloom.launch.substitutions.local_substitution import LocalSubstitution as LocalSubstitution
    from tfloom.launch.substitutions.not_equals_substitution import NotEqualsSubstitution as NotEqualsSubstitution
    from tfloom.launch.substitutions.path_join_substitution import PathJoinSubstitution as PathJoinSubstitution
    from tfloom.launch.substitutions.path_join_substitution import PathSubstitution as PathSubstitution
    from tfloom.launch.substitutions.python_expression import PythonExpression as PythonExpression
    from tfloom.launch.substitutions.string_join_substitution import StringJoinSubstitution as StringJoinSubstitution
    from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure as SubstitutionFailure
    from tfloom.launch.substitutions.text_substitution import TextSubstitution as TextSubstitution
    from tfloom.launch.substitutions.this_launch_file import ThisLaunchFile as ThisLaunchFile
    from tfloom.launch.substitutions.this_launch_file_dir import ThisLaunchFileDir as ThisLaunchFileDir
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        AllSubstitution="tfloom.launch.substitutions.boolean_substitution",
        AndSubstitution="tfloom.launch.substitutions.boolean_substitution",
        AnonName="tfloom.launch.substitutions.anon_name",
        AnySubstitution="tfloom.launch.substitutions.boolean_substitution",
        Command="tfloom.launch.substitutions.command",
        EnvironmentVariable="tfloom.launch.substitutions.environment_variable",
        EqualsSubstitution="tfloom.launch.substitutions.equals_substitution",
        FileContent="tfloom.launch.substitutions.file_content",
        FindExecutable="tfloom.launch.substitutions.find_executable",
        ForEachVar="tfloom.launch.substitutions.for_loop_var",
        ForLoopIndex="tfloom.launch.substitutions.for_loop_var",
        IfElseSubstitution="tfloom.launch.substitutions.if_else_substitution",
        LaunchConfiguration="tfloom.launch.substitutions.launch_configuration",
        LaunchLogDir="tfloom.launch.substitutions.launch_log_dir",
        LocalSubstitution="tfloom.launch.substitutions.local_substitution",
        NotEqualsSubstitution="tfloom.launch.substitutions.not_equals_substitution",
        NotSubstitution="tfloom.launch.substitutions.boolean_substitution",
        OrSubstitution="tfloom.launch.substitutions.boolean_substitution",
        PathJoinSubstitution="tfloom.launch.substitutions.path_join_substitution",
        PathSubstitution="tfloom.launch.substitutions.path_join_substitution",
        PythonExpression="tfloom.launch.substitutions.python_expression",
        StringJoinSubstitution="tfloom.launch.substitutions.string_join_substitution",
        SubstitutionFailure="tfloom.launch.substitutions.substitution_failure",
        TextSubstitution="tfloom.launch.substitutions.text_substitution",
        ThisLaunchFile="tfloom.launch.substitutions.this_launch_file",
        ThisLaunchFileDir="tfloom.launch.substitutions.this_launch_file_dir",
        anon_name="launch.substitutions",
        boolean_substitution="launch.substitutions",
        command="launch.substitutions",
        environment_variable="launch.substitutions",
        equals_substitution="launch.substitutions",
        file_content="launch.substitutions",
        find_executable="launch.substitutions",
        for_loop_var="launch.substitutions",
        if_else_substitution="launch.substitutions",
        launch_configuration="launch.substitutions",
        launch_log_dir="launch.substitutions",
        local_substitution="launch.substitutions",
        not_equals_substitution="launch.substitutions",
        path_join_substitution="launch.substitutions",
        python_expression="launch.substitutions",
        string_join_substitution="launch.substitutions",
        substitution_failure="launch.substitutions",
        text_substitution="launch.substitutions",
        this_launch_file="launch.substitutions",
        this_launch_file_dir="launch.substitutions",
    )
