"""Handlers of logs: nothing public."""
