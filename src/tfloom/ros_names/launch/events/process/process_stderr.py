"""Error output of a process."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.process.process_stderr import ProcessStderr as ProcessStderr
