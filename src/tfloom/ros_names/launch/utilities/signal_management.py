"""Signals in an asyncio program."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.utilities.signal_management import AsyncSafeSignalManager as AsyncSafeSignalManager
