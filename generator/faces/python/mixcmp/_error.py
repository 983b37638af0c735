"""The exception of mixcmp, in a module of its own so that the extension module can raise it."""


class Error(ValueError):
    """A mistake of the user, with its place and what would be right.

    ``str(error)`` is the message that the program would print. The attributes ``file``, ``line``,
    ``field``, ``message``, ``received`` and ``accepted`` are its parts; a part that has no meaning
    is empty, or 0. ``missing_tool`` is true where a program is needed that is not installed.
    """

    def __init__(self, text: str, *, file: str = "", line: int = 0, field: str = "",
                 message: str = "", received: str = "", accepted: str = "",
                 missing_tool: bool = False) -> None:
        super().__init__(text)
        self.file = file
        self.line = line
        self.field = field
        self.message = message
        self.received = received
        self.accepted = accepted
        self.missing_tool = missing_tool
