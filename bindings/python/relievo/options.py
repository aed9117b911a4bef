"""The options, and the checks of their names and values."""

from __future__ import annotations

import difflib
from typing import Any, List, Literal, Mapping, Optional, Tuple, TypedDict, TypeVar

from . import _core
from .errors import UsageError

T = TypeVar("T")


class BuildOptions(TypedDict, total=False):
    method: Literal["approximate", "nonlinear"]
    vertices: int  #: approximate number in the mesh
    edge: float  #: length of edges along outlines in px; replaces `vertices`
    alpha0: float  #: how firmly ramps beside joins are held where they begin, 0 to 1
    rho: float  #: softness of ramps beside joins
    lambda_bnd: float  #: for nonlinear: how firmly outlines beside joins stay down
    lambda_shift: float  #: for nonlinear: the cost of a shift
    glue: bool  #: keep outlines beside joins on the part below
    attach: bool  #: let them leave its surface gradually


class SolidOptions(TypedDict, total=False):
    size: float  #: mm, longest side
    back: Literal["flat", "plain", "mirror", "parts"]
    base: Literal["none", "outline", "plate", "round"]
    mirror: List[str]  #: ids of limbs to copy to the far side of a figure
    height: float  #: mm, maximum; 0: any
    detail: bool  #: keep the depth of small forms if `height` reduces that of the whole
    thickness: float  #: mm below the lowest visible point
    margin: float  #: mm from the silhouette to the edge of the plate
    corner: float  #: mm, radius of the corners of a rectangle
    hole: float  #: mm, diameter of a hole to hang it by; 0: none
    ring: float  #: mm, diameter of the hole in a loop at the top; 0: none
    cutter: float  #: mm, height above the plate of a thin wall around it; 0: none
    ink: Literal["shell", "paint", "none"]  #: contours: lines of their own, for .glb and .usdz, or as colours
    ink_width: float  #: factor for the width of lines


class RenderOptions(TypedDict, total=False):
    width: int  #: px
    height: int  #: px
    yaw: float  #: degrees by which the camera turns to the right
    pitch: float  #: degrees by which the camera is raised
    window: Optional[Tuple[float, float, float]]  #: x and y of the centre, and width, canvas px
    shading: Literal["clay", "textured"]
    background: Literal["transparent", "white", "gradient"]
    light: Tuple[float, float, float]  #: direction towards the light; x right, y up, z to the camera
    light_radius: float  #: apparent radius of the light, degrees
    samples: int  #: rays per pixel
    ambient_rays: int  #: for ambient occlusion, per sample
    ink: Literal["shell", "paint", "none"]  #: contours of a surface


def member(kind: Any, name: str, value: object) -> Any:
    """Returns the member of an enumeration by its name. Raises UsageError for unknown names."""
    members = kind.__members__
    if value not in members:
        raise UsageError(f"must be one of {', '.join(members)}, not {value!r}", name)
    return members[value]


def apply(options: T, given: Mapping[str, object]) -> T:
    """Sets the given options, and returns `options`. Raises TypeError for unknown names and wrong types."""
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


def contours(name: Optional[str]) -> Optional[_core.Ink]:
    found: Optional[_core.Ink] = None if name is None else member(_core.Ink, "ink", name)
    return found


def paint(name: str) -> _core.Slicer:
    found: _core.Slicer = member(_core.Slicer, "slicer", name)
    return found
