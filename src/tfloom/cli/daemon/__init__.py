"""`daemon`: there is none, and the verbs say so."""
