"""Quality of service as programs state it, and what parameters override of it."""
