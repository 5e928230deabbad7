"""The verbs of `ros2` as classes that other programs run and derive from, as `ros2topic.verb.echo.EchoVerb`.

`builtin_verb.py` is their base; each other file has the verbs of one command, and `topic_rates.py` what the verbs about
rates measure with.
"""
