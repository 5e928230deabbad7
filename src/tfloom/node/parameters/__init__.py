"""Parameters: values, YAML files, checks, and the declared parameters of a node."""
