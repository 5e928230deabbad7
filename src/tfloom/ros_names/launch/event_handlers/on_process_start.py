"""Handler of the start of a process."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.event_handlers.on_process_start import OnProcessStart as OnProcessStart
