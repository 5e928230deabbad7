"""What all rooms use, and what knows none of them.

- files: files that appear complete or not at all; files whose names come from outside
- yaml, yaml_scanner: the one door for reading YAML, with limits; tabs as libyaml takes them
- xml: the one door for XML: launch files, package.xml, URDF
- terminal, keyboard: what a terminal would obey, shown; single keys from a terminal
- signals: handlers of signals that run after a block
- text, seconds: values, times and durations in the texts of errors and in output
- notebook: tables and drawings that objects show in notebooks
- access: who may open a page or a WebSocket;  inner_port: ports of libraries, closed to other processes
"""
