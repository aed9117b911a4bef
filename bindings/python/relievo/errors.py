"""What is raised where something cannot be done."""


class Error(Exception):
    """What is wrong (`message`) and its culprit (`where`: a file, part, option or path into a scene;
    may be empty)."""

    def __init__(self, message: str, where: str = "") -> None:
        super().__init__(f"{where}: {message}" if where else message)
        self.message = message
        self.where = where


class UsageError(Error, ValueError):
    """The call itself is wrong: an option out of its range."""


class BadInputError(Error, ValueError):
    """A file or a scene does not say something valid."""


class ContradictionError(Error, ValueError):
    """Annotations cannot all hold."""


class LimitError(Error):
    """Too large, too long, too much memory."""


class FileError(Error, OSError):
    """Reading or writing failed."""


class InternalError(Error):
    """A defect of Relievo."""
