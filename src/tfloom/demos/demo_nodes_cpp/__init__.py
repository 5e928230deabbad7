"""The programs of demo_nodes_cpp that tutorials and tests start; those that demo_nodes_py has alike are its own.

- talker: a greeting once a second
- add_two_ints_client, add_two_ints_client_async: the sum of 2 and 3, by a service
"""
