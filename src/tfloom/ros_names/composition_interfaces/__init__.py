"""The interfaces of composition_interfaces."""
