"""`service`: inspect services, and call them."""
