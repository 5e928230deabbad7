"""Frames over time for ROS programs: buffers, listeners, broadcasters, and operations on transforms.

- buffer*: a buffer filled by a listener, and by an action of another node
- transform_listener, listener_base: `drop_in` has the base, too
- geometry, kdl: transformations of messages
- point_clouds/: clouds as arrays
- message_filter, message_filters, delta_filter, input_aligner: messages by their transforms, stamps and changes
- transformations/: tf_transformations
"""
