"""The wire of rmw_cyclonedds: DDS through libddsc, the library of Cyclone DDS.

- wire: participants;  endpoints, services: writers and readers; servers and clients
- graph, discovery_info: who is there: DDS discovery, and the lists of nodes on `ros_discovery_info`
- library, threads: the search for libddsc, and whether it can start its threads
- config, ports: the range of discovery; who holds the ports of a domain
"""
