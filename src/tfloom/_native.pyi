"""The compiled core of tfloom: numbers, ids and bytes."""



class Sink:
    """Takes serialized samples without Python; see `Reader.feed`."""

    def push(self, data: bytes, source_stamp_ns: int, received_stamp_ns: int, publisher_gid: bytes) -> None:
        """
        Push one sample: encapsulation header and CDR, stamps [ns since epoch], 16 octets of gid.
        """

class ReadyQueue:
    """
    Tokens of entities that have something to do: any thread posts, one thread waits.
    """

    def __init__(self) -> None: ...

    def post(self, token: int) -> None:
        """
        Post a token. One that is posted again before it is taken is taken once.
        """

    def wait(self, timeout_ns: int) -> list[int]:
        """
        Wait for tokens and take all of them, in order of first posting.

        Does not wait with a timeout of 0, waits for ever with a negative one. Empty on a timeout. Releases the GIL; a signal's Python handler runs at once, and what it raises is raised here.
        """
