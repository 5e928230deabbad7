"""Processes of a launch: started, signalled, and ended with all that they have started.

- local_process: one process group, with pipes or terminals
- family: all processes of a launch, found by its id in their environment
- guard: ends what is left at the launch's end, in its process
- guardian: does it if the launch itself is killed, in a separate process
"""
