"""Handlers of the events of nodes."""
