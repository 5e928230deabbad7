"""Forms of pages: made from any type; what is filled in is published, called, or sent as a goal.

- type_form: what a page needs to make the form of a type
- filling: from what a page filled in to a message, with bounds
- asking: a request of one service, and a goal of one action, without waits
- sending: the thread that does what forms ask for
"""
