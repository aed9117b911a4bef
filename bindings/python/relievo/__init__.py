"""Turns drawings of characters into seamless high reliefs:

relievo.build("wolf.svg").save("wolf.glb")
"""

from ._core import Maps, ModelPart, Report, SolidFacts, version as __version__
from .errors import (
    BadInputError,
    ContradictionError,
    Error,
    FileError,
    InternalError,
    LimitError,
    UsageError,
)
from .relief import Model, Relief, build, save_picture
from .scene import Cue, Join, Part, Ramp, Relation, Scene

__all__ = [
    "BadInputError",
    "ContradictionError",
    "Cue",
    "Error",
    "FileError",
    "InternalError",
    "Join",
    "LimitError",
    "Maps",
    "Model",
    "ModelPart",
    "Part",
    "Ramp",
    "Relation",
    "Relief",
    "Report",
    "Scene",
    "SolidFacts",
    "UsageError",
    "build",
    "save_picture",
]
