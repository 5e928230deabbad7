"""`lifecycle`: states and transitions of lifecycle nodes."""
