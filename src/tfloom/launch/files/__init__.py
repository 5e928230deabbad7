"""Launch files: descriptions in Python, XML and YAML."""
