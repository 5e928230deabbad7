"""`daemon`: the verbs print that there is none."""
