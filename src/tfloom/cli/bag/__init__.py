"""The verbs of `bag`."""
