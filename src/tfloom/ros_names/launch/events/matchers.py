"""Matchers of actions."""

from tfloom.launch.action import Action as Action
from tfloom.launch.events.matchers import matches_action as matches_action
