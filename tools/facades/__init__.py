"""The generator of the façades in `src/tfloom/ros_names/`, and the table that it reads."""
