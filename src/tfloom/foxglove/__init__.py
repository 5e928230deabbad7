"""foxglove_bridge: a graph for Foxglove, over a WebSocket, by foxglove-sdk, which the extra `foxglove` installs.

- program, settings: the program, and its parameters
- bridge, commands: the node, what it does for its clients, and how their requests get onto its thread
- shares: limits that clients share
- relay: the bridge's port;  own_client: the bridge's own connection to the SDK's behind it
- channels: topics, to clients;  client_topics: topics, from clients;  known_types: their types
- services, calls, parameters, assets: what clients ask for;  complaints: what could not be done
"""
