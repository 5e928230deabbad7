"""Launch: descriptions of processes and what is done on their events, and the service that runs a description.

A launch description is a tree of entities; `launch_service.py` visits it and handles events in order, and its docstring
says how. Files hold what belongs together; the names of the reference's files are those of the façades.

From the bottom up:

- logs/: where lines go
- core/: the state that entities share, and base classes
- utilities/: texts, and values of a type
- entities/: actions, conditions and descriptions
- events/: what happens, and what is done then
- processes/: a process group, with pipes or terminals; who ends what is left, also if the launch is killed
- frontend/: elements of launch files, and the tables of tags and substitutions
- substitutions/: texts at the run
- files/: launch files in Python, XML and YAML
- actions/: `execute_local` runs a process from its start to its end
- launch_service: the engine
- launch_introspector: `--print`
- ros/: launch_ros: nodes, parameters, lifecycle; the one part that imports `tfloom.node`
- testing/: launch_testing; in fixtures/ launch_pytest, in ros/ launch_testing_ros
"""
