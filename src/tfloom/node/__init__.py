"""What rclpy exposes, in rooms: each imports only itself and the rooms before it.

From the bottom up:

- values/: times, durations, names, types, handles
- log/: records, levels, files, filters
- parameters/: values, YAML files, and the declared parameters of one node
- context/: from `init` to `shutdown`; the participant, `--ros-args`, a warning of a topic with two types
- qos/: profiles, overrides, the endpoints of a topic
- clock/: clocks and time jumps
- executing/: entities, which an executor runs; groups, tasks, timers, signals, the executors
- endpoints/: publishers, subscriptions, services, clients; service introspection
- base/: NodeBase, a node without built-in services; its members: its graph, its names, what it created
- builtin/: what Node adds: rosout, time source, services of parameters, loggers and types; clients of these
- node, client_library, program: Node; init, spin, shutdown; start and end of tfloom's programs
- velocities: what drives a robot, and stops it at its end
- turtlesim_types: turtlesim's interfaces, whose package differs between distributions
- cpp_nodes: what programs that stand for nodes in C++ show
- implementation: the names of rclpy's compiled half
- wait_for_message: one message of a topic
- action/: actions: client, server, goals
- lifecycle/: nodes with a lifecycle
- async_node: nodes on asyncio, without an executor

The errors that several rooms raise are in `values/exceptions.py`; each other error is in the file that raises it.

A class declares what it needs of a later room by a Protocol of its own: `TaskRunner` (an executor, as a future needs
it), `SpunNode` (a node, as an executor needs it), `DestroyableNode` (a node, as a context needs it), `GoalServer` (an
action server, as a goal needs it).
"""
