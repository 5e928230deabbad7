"""What nodes and commands share on top of any wire.

- endpoint_text: an endpoint of the graph as text
- waiting, service_request: waits, and a request of a service in steps
- peer_types: types that other nodes describe, and the searches for them
- qos_mismatch: the warning about qualities that don't match
"""
