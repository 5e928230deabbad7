"""The start of a process."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.process.process_started import ProcessStarted as ProcessStarted
