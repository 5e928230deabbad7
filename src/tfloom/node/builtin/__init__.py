"""What every node runs by itself, and the clients of that: parameter services, log services, time source."""
