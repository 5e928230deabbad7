"""Parameters: values, the files and rules for them, and the parameters that a node has declared."""
