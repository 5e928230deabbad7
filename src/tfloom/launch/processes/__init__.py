"""Processes of a launch: started, signalled, and ended with all that they have started."""
