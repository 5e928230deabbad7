"""Bytes over a wire: topics, qualities of service, the graph, and the backends behind one interface (`base`).

- base: the interface of the wires
- backends: the table of wires, by the value of RMW_IMPLEMENTATION
- local*: the wire inside the process
- cyclone*: the wire on libddsc
- zenoh*: the wire on eclipse-zenoh, from `zenoh_wire`; its configuration and its routers
- services, events, endpoint_events, qos, compatibility: what the wires share
- callback_files: where Ctrl-C waits
- forks: what a forked process has inherited
- service_request: a request of a service, in steps; peer_types: types that other nodes describe
- waiting, typed_names, action_names, endpoint_text, qos_mismatch: what nodes and commands share
"""
