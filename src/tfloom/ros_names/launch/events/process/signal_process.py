"""A signal to some processes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.process.signal_process import SignalProcess as SignalProcess
