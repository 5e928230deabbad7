"""The tree of transforms in a terminal, with rates, ages and publishers as they change."""
