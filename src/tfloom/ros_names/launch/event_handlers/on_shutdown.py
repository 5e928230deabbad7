"""Handler of the launch's end."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.event_handlers.on_shutdown import OnShutdown as OnShutdown
