"""Handlers of the events that launch files react to."""
