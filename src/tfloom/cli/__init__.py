"""The commands: `tfloom VERB …`, and `ros2 VERB …` where the distribution `tfloom-ros2` is installed."""
