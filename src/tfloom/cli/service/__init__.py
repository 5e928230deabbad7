"""`service`: ask about services, and call them."""
