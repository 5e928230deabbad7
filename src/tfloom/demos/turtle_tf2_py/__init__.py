"""The turtles of the tf2 tutorials: who broadcasts where they are, and who follows whom."""
