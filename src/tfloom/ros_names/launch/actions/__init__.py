"""Actions, of which launch descriptions consist."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "AppendEnvironmentVariable",
    "DeclareLaunchArgument",
    "EmitEvent",
    "ExecuteLocal",
    "ExecuteProcess",
    "ForEach",
    "ForLoop",
    "GroupAction",
    "IncludeLaunchDescription",
    "Log",
    "LogDebug",
    "LogError",
    "LogInfo",
    "LogWarning",
    "OpaqueCoroutine",
    "OpaqueFunction",
    "PopEnvironment",
    "PopLaunchConfigurations",
    "PushEnvironment",
    "PushLaunchConfigurations",
    "RegisterEventHandler",
    "ResetEnvironment",
    "ResetLaunchConfigurations",
    "SetEnvironmentVariable",
    "SetLaunchConfiguration",
    "Shutdown",
    "TimerAction",
    "UnregisterEventHandler",
    "UnsetEnvironmentVariable",
    "UnsetLaunchConfiguration",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch.actions import append_environment_variable as append_environment_variable
    from launch.actions import declare_launch_argument as declare_launch_argument
    from launch.actions import emit_event as emit_event
    from launch.actions import execute_local as execute_local
    from launch.actions import execute_process as execute_process
    from launch.actions import for_loop as for_loop
    from launch.actions import group_action as group_action
    from launch.actions import include_launch_description as include_launch_description
    from launch.actions import log as log
    from launch.actions import log_info as log_info
    from launch.actions import opaque_coroutine as opaque_coroutine
    from launch.actions import opaque_function as opaque_function
    from launch.actions import pop_environment as pop_environment
    from launch.actions import pop_launch_configurations as pop_launch_configurations
    from launch.actions import push_environment as push_environment
    from launch.actions import push_launch_configurations as push_launch_configurations
    from launch.actions import register_event_handler as register_event_handler
    from launch.actions import reset_environment as reset_environment
    from launch.actions import reset_launch_configurations as reset_launch_configurations
    from launch.actions import set_environment_variable as set_environment_variable
    from launch.actions import set_launch_configuration as set_launch_configuration
    from launch.actions import shutdown_action as shutdown_action
    from launch.actions import timer_action as timer_action
    from launch.actions import unregister_event_handler as unregister_event_handler
    from launch.actions import unset_environment_variable as unset_environment_variable
    from launch.actions import unset_launch_configuration as unset_launch_configuration
    from tfloom.launch.actions.append_environment_variable import AppendEnvironmentVariable as AppendEnvironmentVariable
    from tfloom.launch.actions.declare_launch_argument import DeclareLaunchArgument as DeclareLaunchArgument
    from tfloom.launch.actions.emit_event import EmitEvent as EmitEvent
    from tfloom.launch.actions.execute_local import ExecuteLocal as ExecuteLocal
    from tfloom.launch.actions.execute_process import ExecuteProcess as ExecuteProcess
    from tfloom.launch.actions.for_loop import ForEach as ForEach
    from tfloom.launch.actions.for_loop import ForLoop as ForLoop
    from tfloom.launch.actions.group_action import GroupAction as GroupAction
    from tfloom.launch.actions.include_launch_description import IncludeLaunchDescription as IncludeLaunchDescription
    from tfloom.launch.actions.log import Log as Log
    from tfloom.launch.actions.log import LogDebug as LogDebug
    from tfloom.launch.actions.log import LogError as LogError
    from tfloom.launch.actions.log import LogInfo as LogInfo
    from tfloom.launch.actions.log import LogWarning as LogWarning
    from tfloom.launch.actions.opaque_coroutine import OpaqueCoroutine as OpaqueCoroutine
    from tfloom.launch.actions.opaque_function import OpaqueFunction as OpaqueFunction
    from tfloom.launch.actions.pop_environment import PopEnvironment as PopEnvironment
    from tfloom.launch.actions.pop_launch_configurations import PopLaunchConfigurations as PopLaunchConfigurations
    from tfloom.launch.actions.push_environment import PushEnvironment as PushEnvironment
    from tfloom.launch.actions.push_launch_configurations import PushLaunchConfigurations as PushLaunchConfigurations
    from tfloom.launch.actions.register_event_handler import RegisterEventHandler as RegisterEventHandler
    from tfloom.launch.actions.reset_environment import ResetEnvironment as ResetEnvironment
    from tfloom.launch.actions.reset_launch_configurations import ResetLaunchConfigurations as ResetLaunchConfigurations
    from tfloom.launch.actions.set_environment_variable import SetEnvironmentVariable as SetEnvironmentVariable
    from tfloom.launch.actions.set_launch_configuration import SetLaunchConfiguration as SetLaunchConfiguration
    from tfloom.launch.actions.shutdown_action import Shutdown as Shutdown
    from tfloom.launch.actions.timer_action import TimerAction as TimerAction
    from tfloom.launch.actions.unregister_event_handler import UnregisterEventHandler as UnregisterEventHandler
    from tfloom.launch.actions.unset_environment_variable import UnsetEnvironmentVariable as UnsetEnvironmentVariable
    from tfloom.launch.actions.unset_launch_configuration import UnsetLaunchConfiguration as UnsetLaunchConfiguration
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        AppendEnvironmentVariable="tfloom.launch.actions.append_environment_variable",
        DeclareLaunchArgument="tfloom.launch.actions.declare_launch_argument",
        EmitEvent="tfloom.launch.actions.emit_event",
        ExecuteLocal="tfloom.launch.actions.execute_local",
        ExecuteProcess="tfloom.launch.actions.execute_process",
        ForEach="tfloom.launch.actions.for_loop",
        ForLoop="tfloom.launch.actions.for_loop",
        GroupAction="tfloom.launch.actions.group_action",
        IncludeLaunchDescription="tfloom.launch.actions.include_launch_description",
        Log="tfloom.launch.actions.log",
        LogDebug="tfloom.launch.actions.log",
        LogError="tfloom.launch.actions.log",
        LogInfo="tfloom.launch.actions.log",
        LogWarning="tfloom.launch.actions.log",
        OpaqueCoroutine="tfloom.launch.actions.opaque_coroutine",
        OpaqueFunction="tfloom.launch.actions.opaque_function",
        PopEnvironment="tfloom.launch.actions.pop_environment",
        PopLaunchConfigurations="tfloom.launch.actions.pop_launch_configurations",
        PushEnvironment="tfloom.launch.actions.push_environment",
        PushLaunchConfigurations="tfloom.launch.actions.push_launch_configurations",
        RegisterEventHandler="tfloom.launch.actions.register_event_handler",
        ResetEnvironment="tfloom.launch.actions.reset_environment",
        ResetLaunchConfigurations="tfloom.launch.actions.reset_launch_configurations",
        SetEnvironmentVariable="tfloom.launch.actions.set_environment_variable",
        SetLaunchConfiguration="tfloom.launch.actions.set_launch_configuration",
        Shutdown="tfloom.launch.actions.shutdown_action",
        TimerAction="tfloom.launch.actions.timer_action",
        UnregisterEventHandler="tfloom.launch.actions.unregister_event_handler",
        UnsetEnvironmentVariable="tfloom.launch.actions.unset_environment_variable",
        UnsetLaunchConfiguration="tfloom.launch.actions.unset_launch_configuration",
        append_environment_variable="launch.actions",
        declare_launch_argument="launch.actions",
        emit_event="launch.actions",
        execute_local="launch.actions",
        execute_process="launch.actions",
        for_loop="launch.actions",
        group_action="launch.actions",
        include_launch_description="launch.actions",
        log="launch.actions",
        log_info="launch.actions",
        opaque_coroutine="launch.actions",
        opaque_function="launch.actions",
        pop_environment="launch.actions",
        pop_launch_configurations="launch.actions",
        push_environment="launch.actions",
        push_launch_configurations="launch.actions",
        register_event_handler="launch.actions",
        reset_environment="launch.actions",
        reset_launch_configurations="launch.actions",
        set_environment_variable="launch.actions",
        set_launch_configuration="launch.actions",
        shutdown_action="launch.actions",
        timer_action="launch.actions",
        unregister_event_handler="launch.actions",
        unset_environment_variable="launch.actions",
        unset_launch_configuration="launch.actions",
    )
