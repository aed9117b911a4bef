"""Options by name: what there is, and how what a caller gives is checked."""

from __future__ import annotations

import difflib
from typing import Any, List, Literal, Mapping, Optional, Tuple, TypedDict, TypeVar

from . import _core
from .errors import UsageError

T = TypeVar("T")


class BuildOptions(TypedDict, total=False):
    method: Literal["approximate", "nonlinear"]
    vertices: int  #: of the mesh, roughly
    edge: float  #: length of edges along outlines in px, in place of `vertices`
    alpha0: float  #: how firmly ramps beside joins begin, 0 to 1
    rho: float  #: softness of ramps beside joins
    lambda_bnd: float  #: of nonlinear: how firmly outlines beside joins stay down
    lambda_shift: float  #: of nonlinear: what a shift costs
    glue: bool  #: outlines beside joins lie on the part below
    attach: bool  #: they begin at its height and come loose gradually


class SolidOptions(TypedDict, total=False):
    size: float  #: mm, longest side
    back: Literal["flat", "drawing", "parts"]
    base: Literal["none", "outline", "plate", "round"]
    mirror: List[str]  #: of a figure: parts that its far side gets too
    height: float  #: mm at most; 0: any
    detail: bool  #: small forms keep their depth where there is more than `height`
    thickness: float  #: mm below the lowest point that is seen
    margin: float  #: mm from the silhouette to the plate's edge
    corner: float  #: mm, radius of a rectangle's corners
    hole: float  #: mm, diameter of a hole to hang it by; 0: none
    ring: float  #: mm, diameter of a hole in a loop at its top; 0: none
    cutter: float  #: mm, height above the plate of a thin wall around it; 0: none


class RenderOptions(TypedDict, total=False):
    width: int  #: px
    height: int  #: px
    yaw: float  #: degrees by which the camera moves to its right
    pitch: float  #: degrees by which it moves up
    window: Optional[Tuple[float, float, float]]  #: x and y of its middle and its width, canvas px
    shading: Literal["clay", "textured"]
    background: Literal["transparent", "white", "gradient"]
    light: Tuple[float, float, float]  #: towards it; x right, y up, z to the camera
    light_radius: float  #: degrees
    samples: int  #: rays a pixel
    ambient_rays: int


def member(kind: Any, name: str, value: object) -> Any:
    """The value of an enumeration that is called `value`."""
    members = kind.__members__
    if value not in members:
        raise UsageError(f"must be one of {', '.join(members)}, not {value!r}", name)
    return members[value]


def apply(options: T, given: Mapping[str, object]) -> T:
    """`options` with the values given; other names and kinds of values are refused by name."""
    known = [name for name in dir(options) if not name.startswith("_")]
    for name, value in given.items():
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            hint = f"; did you mean {near[0]}?" if near else ""
            raise TypeError(f"there is no option {name!r}{hint}")
        current = getattr(options, name)
        if hasattr(type(current), "__members__"):
            value = member(type(current), name, value)
        try:
            setattr(options, name, value)
        except TypeError:
            raise TypeError(
                f"{name} must be like {current!r}, not {value!r}"
            ) from None
    return options


def visibility(name: str) -> _core.Visibility:
    found: _core.Visibility = member(_core.Visibility, "visible", name)
    return found


def field(name: str) -> _core.Field:
    found: _core.Field = member(_core.Field, "shown", name)
    return found


def paint(name: str) -> _core.Slicer:
    found: _core.Slicer = member(_core.Slicer, "slicer", name)
    return found
