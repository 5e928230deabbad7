"""Forms of pages: made from any type; what is filled in is published, called, or sent as a goal.

- type_form: what a page needs to make the form of a type
- filling: from what a page filled in to a message, with bounds
- task: what is under way for a page; publishing, asking: its kinds
- sending: the thread that does what forms ask for
"""
