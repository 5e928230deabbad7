"""`param`: read and change the parameters of nodes."""
