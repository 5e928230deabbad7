"""The wire of rmw_zenoh: topics, services and the graph over eclipse-zenoh.

- wire: participants;  end, endpoints, services, feeder, events: writers and readers; servers and clients
- tokens: keys, liveliness tokens, and the attachment of each sample
- graph, announced: who is there, by the tokens;  library: the search for eclipse-zenoh
- session, config: how a process joins and leaves
- router, meeting_point, links, port_holder: the router, inside a process or by itself, and why it can't be reached
"""
