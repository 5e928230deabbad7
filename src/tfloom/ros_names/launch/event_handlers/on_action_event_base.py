"""The base class of the handlers of events that belong to an action."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.event_handlers.on_action_event_base import OnActionEventBase as OnActionEventBase
