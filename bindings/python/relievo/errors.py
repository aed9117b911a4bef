"""The exceptions that Relievo raises."""


class Error(Exception):
    """An error with its `message` and its place, `where`: a file, part, option or path in a scene, or
    empty."""

    def __init__(self, message: str, where: str = "") -> None:
        super().__init__(f"{where}: {message}" if where else message)
        self.message = message
        self.where = where


class UsageError(Error, ValueError):
    """A call is wrong, such as an option out of range."""


class BadInputError(Error, ValueError):
    """A file or scene is invalid."""


class ContradictionError(Error, ValueError):
    """The annotations contradict each other."""


class LimitError(Error):
    """A size, time or amount of memory is over its limit."""


class FileError(Error, OSError):
    """A file cannot be read or written."""


class InternalError(Error):
    """An internal error; please report it."""
