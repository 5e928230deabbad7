"""Actions that start nodes, or that change how later ones are started."""
