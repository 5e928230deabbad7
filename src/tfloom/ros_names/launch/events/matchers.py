"""Matchers of actions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.matchers import matches_action as matches_action
