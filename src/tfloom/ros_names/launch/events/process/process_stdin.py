"""Input for some processes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.process.process_stdin import ProcessStdin as ProcessStdin
