"""Actions: goals that take time, with feedback on the way and a result at the end."""
