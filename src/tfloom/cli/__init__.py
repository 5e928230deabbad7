"""The commands: `tfloom VERB …`, and `ros2 VERB …` if the distribution `tfloom-ros2` is installed."""
