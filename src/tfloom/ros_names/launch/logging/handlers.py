"""Handlers of logs: nothing public."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.
