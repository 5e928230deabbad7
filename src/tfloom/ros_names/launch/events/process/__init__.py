"""Events of processes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "ProcessExited",
    "ProcessIO",
    "ProcessStarted",
    "ProcessStderr",
    "ProcessStdin",
    "ProcessStdout",
    "ProcessTargetedEvent",
    "RunningProcessEvent",
    "ShutdownProcess",
    "SignalProcess",
    "matches_executable",
    "matches_name",
    "matches_pid",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch.events.process import process_exited as process_exited
    from launch.events.process import process_io as process_io
    from launch.events.process import process_matchers as process_matchers
    from launch.events.process import process_started as process_started
    from launch.events.process import process_stderr as process_stderr
    from launch.events.process import process_stdin as process_stdin
    from launch.events.process import process_stdout as process_stdout
    from launch.events.process import process_targeted_event as process_targeted_event
    from launch.events.process import running_process_event as running_process_event
    from launch.events.process import shutdown_process as shutdown_process
    from launch.events.process import signal_process as signal_process
    from tfloom.launch.events.process.process_exited import ProcessExited as ProcessExited
    from tfloom.launch.events.process.process_io import ProcessIO as ProcessIO
    from tfloom.launch.events.process.process_matchers import matches_executable as matches_executable
    from tfloom.launch.events.process.process_matchers import matches_name as matches_name
    from tfloom.launch.events.process.process_matchers import matches_pid as matches_pid
    from tfloom.launch.events.process.process_started import ProcessStarted as ProcessStarted
    from tfloom.launch.events.process.process_stderr import ProcessStderr as ProcessStderr
    from tfloom.launch.events.process.process_stdin import ProcessStdin as ProcessStdin
    from tfloom.launch.events.process.process_stdout import ProcessStdout as ProcessStdout
    from tfloom.launch.events.process.process_targeted_event import ProcessTargetedEvent as ProcessTargetedEvent
    from tfloom.launch.events.process.running_process_event import RunningProcessEvent as RunningProcessEvent
    from tfloom.launch.events.process.shutdown_process import ShutdownProcess as ShutdownProcess
    from tfloom.launch.events.process.signal_process import SignalProcess as SignalProcess
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ProcessExited="tfloom.launch.events.process.process_exited",
        ProcessIO="tfloom.launch.events.process.process_io",
        ProcessStarted="tfloom.launch.events.process.process_started",
        ProcessStderr="tfloom.launch.events.process.process_stderr",
        ProcessStdin="tfloom.launch.events.process.process_stdin",
        ProcessStdout="tfloom.launch.events.process.process_stdout",
        ProcessTargetedEvent="tfloom.launch.events.process.process_targeted_event",
        RunningProcessEvent="tfloom.launch.events.process.running_process_event",
        ShutdownProcess="tfloom.launch.events.process.shutdown_process",
        SignalProcess="tfloom.launch.events.process.signal_process",
        matches_executable="tfloom.launch.events.process.process_matchers",
        matches_name="tfloom.launch.events.process.process_matchers",
        matches_pid="tfloom.launch.events.process.process_matchers",
        process_exited="launch.events.process",
        process_io="launch.events.process",
        process_matchers="launch.events.process",
        process_started="launch.events.process",
        process_stderr="launch.events.process",
        process_stdin="launch.events.process",
        process_stdout="launch.events.process",
        process_targeted_event="launch.events.process",
        running_process_event="launch.events.process",
        shutdown_process="launch.events.process",
        signal_process="launch.events.process",
    )
