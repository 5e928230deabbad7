"""Checks of the machine, the wire and the graph: `tfloom doctor`.

- command: the verb;  finding: the finding of a check
- checks: the checks of this machine and of the environment
- peers, wires, zenoh: the checks of other participants and qualities of service, of other wires, and of routers
"""
