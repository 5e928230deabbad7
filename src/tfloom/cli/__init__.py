"""The commands: `tfloom VERB …`, and `ros2 VERB …` if the distribution `tfloom-ros2` is installed.

- start, quiet_imports: the entry point;  main: the table of verbs
- launch_api: ros2launch.api;  page_programs, rqt: rviz2, joint_state_publisher_gui and rqt, which open the page
- api/: what programs import from the packages of the other commands, as ros2topic.api; nodes for a block
- plugins/: commands and verbs of installed packages
- shared/: what verbs share;  doctor/: the checks of `tfloom doctor`
- parser, completion, tab_key: arguments, and their completion
- verb_classes/: the verbs as classes for programs, as ros2topic.verb.echo.EchoVerb

The code of a verb is imported when it is called. Those of a group, as `node`, share a file, or are in its folder: the
short ones in `queries`, each other in a file of its name. The table of `main` says which.
"""
