"""The orderly end of some processes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.process.shutdown_process import ShutdownProcess as ShutdownProcess
