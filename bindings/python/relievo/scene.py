"""Scenes: the parts of a drawing and their annotations. Coordinates are canvas px, y down."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import List, Literal, Optional, Tuple

import numpy as np
import numpy.typing as npt

Point = Tuple[float, float]
Line = npt.NDArray[np.float64]  #: n x 2


@dataclass
class Part:
    """A region of the drawing, including what other parts hide."""

    id: str
    outline: List[Line]  #: closed rings without a repeated first point; holes run the other way
    c: float = 4.0  #: inflation: 4 turns a disc into a hemisphere
    d: float = 1.0  #: depth, not 0; negative: away from the viewer
    flat: float = 0.0  #: profile: from 0, round, to 1, a flat top
    lean: Point = (0.0, 0.0)  #: tilt: how much nearer it comes per px to the right and downwards


@dataclass
class Join:
    """A line along which a part continues the surface of another.

    A limb behind the other part meets it along the outline of that part, at a crease.
    """

    upper: str  #: id of the part that grows out of the other
    lower: str
    line: Line


@dataclass
class Relation:
    """A depth relation between two parts that overlap."""

    upper: str
    lower: str
    kind: Literal["equal", "above", "free", "below", "joined"] = "above"
    range: Optional[Tuple[Point, Point]] = None  #: on the upper outline; None: everywhere


@dataclass
class Ramp:
    """A range in which the upper outline leaves the lower part gradually."""

    upper: str
    lower: str
    start: Point
    end: Point
    alpha0: Optional[float] = None
    rho: Optional[float] = None


@dataclass
class Cue:
    """A profile of a part along a line."""

    part: str
    kind: Literal["bulge", "slope", "crease"]
    line: Line
    value: float


@dataclass
class Scene:
    """The parts of a drawing and their annotations. `scene["ear"]` is the part with that id."""

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
