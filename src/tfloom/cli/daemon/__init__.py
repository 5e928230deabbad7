"""`daemon`: the verbs explain that there is none."""
