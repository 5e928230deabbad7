"""Execute a process on this host."""

from typing import TYPE_CHECKING

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.execute_local import ExecuteLocal as ExecuteLocal
from tfloom.launch.descriptions.executable import Executable as Executable
from tfloom.launch.event import Event as Event
from tfloom.launch.event_handler import EventHandler as EventHandler
from tfloom.launch.event_handlers.on_process_exit import OnProcessExit as OnProcessExit
from tfloom.launch.event_handlers.on_shutdown import OnShutdown as OnShutdown
from tfloom.launch.events.process.process_exited import ProcessExited as ProcessExited
from tfloom.launch.events.process.process_io import ProcessIO as ProcessIO
from tfloom.launch.events.process.process_started import ProcessStarted as ProcessStarted
from tfloom.launch.events.process.process_stderr import ProcessStderr as ProcessStderr
from tfloom.launch.events.process.process_stdin import ProcessStdin as ProcessStdin
from tfloom.launch.events.process.process_stdout import ProcessStdout as ProcessStdout
from tfloom.launch.events.process.shutdown_process import ShutdownProcess as ShutdownProcess
from tfloom.launch.events.process.signal_process import SignalProcess as SignalProcess
from tfloom.launch.events.shutdown import Shutdown as Shutdown
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.substitution import Substitution as Substitution
from tfloom.launch.substitutions.launch_configuration import LaunchConfiguration as LaunchConfiguration
from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
    normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
)
from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
from tfloom.launch.utilities.type_utils import normalize_typed_substitution as normalize_typed_substitution
from tfloom.launch.utilities.type_utils import perform_typed_substitution as perform_typed_substitution

if TYPE_CHECKING:
    from tfloom.launch.actions.emit_event import EmitEvent as EmitEvent
    from tfloom.launch.actions.opaque_function import OpaqueFunction as OpaqueFunction
    from tfloom.launch.actions.timer_action import TimerAction as TimerAction
    from tfloom.launch.conditions.evaluate_condition_expression_impl import (
        evaluate_condition_expression as evaluate_condition_expression,
    )
    from tfloom.launch.event_handlers.on_process_io import OnProcessIO as OnProcessIO
    from tfloom.launch.event_handlers.on_process_start import OnProcessStart as OnProcessStart
    from tfloom.launch.events.matchers import matches_action as matches_action
    from tfloom.launch.launch_description import LaunchDescription as LaunchDescription
    from tfloom.launch.substitutions.python_expression import PythonExpression as PythonExpression
    from tfloom.launch.utilities.class_tools import is_a_subclass as is_a_subclass
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        EmitEvent="tfloom.launch.actions.emit_event",
        LaunchDescription="tfloom.launch.launch_description",
        OnProcessIO="tfloom.launch.event_handlers.on_process_io",
        OnProcessStart="tfloom.launch.event_handlers.on_process_start",
        OpaqueFunction="tfloom.launch.actions.opaque_function",
        PythonExpression="tfloom.launch.substitutions.python_expression",
        TimerAction="tfloom.launch.actions.timer_action",
        evaluate_condition_expression="tfloom.launch.conditions.evaluate_condition_expression_impl",
        is_a_subclass="tfloom.launch.utilities.class_tools",
        matches_action="tfloom.launch.events.matchers",
    )
