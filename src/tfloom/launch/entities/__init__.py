"""What a launch visits: actions, descriptions, their sources and event handlers, as base classes.

- action, conditions: the base class of actions, and what they may depend on
- launch_description, launch_description_source: descriptions, and where included ones come from
- event_handler: the base classes of event handlers
"""
