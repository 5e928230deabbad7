"""Events of processes."""
