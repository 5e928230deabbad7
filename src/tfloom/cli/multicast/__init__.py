"""`multicast`: test multicast."""
