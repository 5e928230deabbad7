"""The programs of tf2: printing, monitoring, drawing, serving and publishing transforms."""
