"""The commands: `tfloom VERB …`, and `ros2 VERB …` if the distribution `tfloom-ros2` is installed.

- start, quiet_imports: the entry point;  main: the table of verbs
- launch_api: ros2launch.api;  rviz2, rqt, joint_state_publisher_gui: the programs of these packages
- api/: what programs import from the packages of the other commands, as ros2topic.api
- nodes/: a node for a block, for these and for extensions
- plugins/: commands and verbs of installed packages
- shared/: what verbs share;  doctor/: the checks of `tfloom doctor`
- parser, completion, tab_key: arguments, and their completion
- verb_classes/: the verbs as classes for programs, as ros2topic.verb.echo.EchoVerb

Each verb is a file, imported when it is called; those of a group, as `topic`, are in its folder.
"""
