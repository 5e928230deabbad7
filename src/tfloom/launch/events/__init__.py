"""Events that the launch itself emits or handles."""
