"""What verbs share.

- errors: errors that end a command with a message;  ctrl_c, child: waits for Ctrl-C, and for a child process
- graph, calls, listen, sim_time: the graph, services, topics and the time, without a node
- names, numbers, qos, selection: types of arguments, flags, and users' expressions
- interfaces, type_names, peer_types: types and values of messages
- listing, message_text: what is printed
"""
