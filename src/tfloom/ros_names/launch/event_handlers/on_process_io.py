"""Handler of what processes read and write."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.event_handlers.on_process_io import OnProcessIO as OnProcessIO
