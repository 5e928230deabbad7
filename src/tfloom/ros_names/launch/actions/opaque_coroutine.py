"""Run a coroutine."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.opaque_coroutine import OpaqueCoroutine as OpaqueCoroutine
