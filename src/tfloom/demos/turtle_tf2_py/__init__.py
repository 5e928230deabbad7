"""The turtles of the tf2 tutorials: broadcasters of their poses, and followers."""
