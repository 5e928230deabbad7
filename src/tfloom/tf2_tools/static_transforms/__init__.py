"""Static transforms as a command line and as a file."""
