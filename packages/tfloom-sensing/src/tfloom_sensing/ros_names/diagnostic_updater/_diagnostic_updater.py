"""Tasks, and what runs them."""

from tfloom_sensing.diagnostic_status_wrapper import DiagnosticStatus, DiagnosticStatusWrapper
from tfloom_sensing.diagnostic_tasks import CompositeDiagnosticTask, DiagnosticTask, FunctionDiagnosticTask
from tfloom_sensing.diagnostic_updater import DiagnosticArray, DiagnosticTaskVector, Updater

__all__ = [
    "CompositeDiagnosticTask",
    "DiagnosticArray",
    "DiagnosticStatus",
    "DiagnosticStatusWrapper",
    "DiagnosticTask",
    "DiagnosticTaskVector",
    "FunctionDiagnosticTask",
    "Updater",
]
