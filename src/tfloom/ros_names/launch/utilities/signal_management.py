"""Signals in an asyncio program."""

from tfloom.launch.utilities.signal_management import AsyncSafeSignalManager as AsyncSafeSignalManager
