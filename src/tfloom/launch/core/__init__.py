"""What all of a launch is made of: the base classes, and the state that entities share.

- launch_context, run_state: the state of a launch
- event, base_classes: the base classes of events, conditions, substitutions and entities
- entity: an element of a launch file
- invalid_launch_file_error, error_places, circular_includes: what is wrong with a file, and where
- missing: what a launch skips that is not here
- private_names: names of attributes that the reference has with an underscore
"""
