"""Actions: goals that are executed over time, with feedback and a result."""
