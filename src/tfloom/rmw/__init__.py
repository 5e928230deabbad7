"""Bytes over a wire: topics, qualities of service, the graph, and the backends behind one interface (`base`).

- base: the interface of the wires
- backends: the table of wires, by the value of RMW_IMPLEMENTATION
- local/, cyclone/, zenoh/: the wires: inside the process, on libddsc, on eclipse-zenoh; each begins at its `wire`
- services, events, endpoint_events, qos, compatibility, topic_names, typed_names, errors: what the wires share
- postponed_interrupt: where Ctrl-C waits
- forks: what a forked process has inherited
- shared/: what nodes and commands share
"""
