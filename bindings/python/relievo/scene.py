"""A drawing as its parts: what a relief is built of. Coordinates are px of the canvas, y down."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import List, Literal, Optional, Tuple

import numpy as np
import numpy.typing as npt

Point = Tuple[float, float]
Line = npt.NDArray[np.float64]  #: n x 2


@dataclass
class Part:
    """A region of the drawing, whole also where others hide it."""

    id: str
    outline: List[Line]  #: closed rings, not repeating their first points; holes run against them
    c: float = 4.0  #: inflation: 4 makes a hemisphere of a disc
    d: float = 1.0  #: depth, not 0; negative: away from the viewer
    flat: float = 0.0  #: profile: 0 round, 1 a flat top
    lean: Point = (0.0, 0.0)  #: how much nearer it comes per px to the right and downwards


@dataclass
class Join:
    """A line along which one part is one surface with another.

    A limb that lies behind the other part meets it along that one's outline, at a crease.
    """

    upper: str  #: id of the part that grows out of the other
    lower: str
    line: Line


@dataclass
class Relation:
    """What holds between two parts that overlap."""

    upper: str
    lower: str
    kind: Literal["equal", "above", "free", "below", "joined"] = "above"
    range: Optional[Tuple[Point, Point]] = None  #: of the upper outline; None: everywhere


@dataclass
class Ramp:
    """Where the upper outline comes loose from the lower part gradually."""

    upper: str
    lower: str
    start: Point
    end: Point
    alpha0: Optional[float] = None
    rho: Optional[float] = None


@dataclass
class Cue:
    """What the profile of a part is like along a line."""

    part: str
    kind: Literal["bulge", "slope", "crease"]
    line: Line
    value: float


@dataclass
class Scene:
    """Everything that is known of a drawing. `scene["ear"]` is the part with that id."""

    width: float  #: of the canvas
    height: float
    parts: List[Part] = field(default_factory=list)  #: back to front
    joins: List[Join] = field(default_factory=list)
    relations: List[Relation] = field(default_factory=list)
    ramps: List[Ramp] = field(default_factory=list)
    cues: List[Cue] = field(default_factory=list)

    def __getitem__(self, part: str) -> Part:
        for candidate in self.parts:
            if candidate.id == part:
                return candidate
        raise KeyError(part)
