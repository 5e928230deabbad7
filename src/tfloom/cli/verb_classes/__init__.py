"""The verbs of `ros2` as classes that other programs run and derive from, as `ros2topic.verb.echo.EchoVerb`.

`builtin_verb.py` is their base, `verbs.py` has them, and `topic_rates.py` what the verbs about rates measure with.
"""
