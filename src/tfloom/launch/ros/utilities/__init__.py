"""Names, parameters and remappings of nodes, in the forms that launch files give."""
