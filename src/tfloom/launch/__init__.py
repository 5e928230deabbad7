"""Launch: descriptions of processes and what is done on their events, and the service that runs a description."""
