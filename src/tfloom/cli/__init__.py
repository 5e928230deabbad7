"""The commands: `tfloom VERB …`, and `ros2 VERB …` if the distribution `tfloom-ros2` is installed.

- main: the table of verbs
- launch_api: ros2launch.api

Each verb is a file, imported when it is called; those of a group, as `topic`, are in its folder.
"""
