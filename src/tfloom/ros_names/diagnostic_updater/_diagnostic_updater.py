"""Tasks, and what runs them."""

from tfloom.sensing.diagnostic_status_wrapper import DiagnosticStatus, DiagnosticStatusWrapper
from tfloom.sensing.diagnostic_tasks import *
from tfloom.sensing.diagnostic_updater import *
