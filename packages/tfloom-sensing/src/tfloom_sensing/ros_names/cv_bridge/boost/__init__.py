"""What is compiled in the original."""
