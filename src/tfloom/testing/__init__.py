"""Fixtures of pytest for packages that run on ROS: a graph of one's own, simulated time, transforms from a table.

- plugin: pytest's, which imports the rest when a test asks
- graph, diagnosis, simulated_time, transform_table: the fixtures
- isolation: of the process's state
- domains: of DDS, locked, also for our own tests
"""
