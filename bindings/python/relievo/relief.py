"""Reliefs and models: built, changed, rendered and saved."""

from __future__ import annotations

import os
import pathlib
from typing import TYPE_CHECKING, Any, List, Literal, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .options import BuildOptions, RenderOptions, SolidOptions, apply, contours, field, paint, visibility
from .scene import Scene

if TYPE_CHECKING:
    from typing_extensions import Unpack

Picture = npt.NDArray[np.uint8]
PathLike = Union[str, "os.PathLike[str]"]
Slicer = Literal["prusa", "bambu"]
Visible = Literal["relief", "orbit", "all"]
Ink = Literal["shell", "paint", "none"]

#: Yaw and pitch of the camera, degrees.
VIEWS = {"front": (0.0, 0.0), "three-quarter": (38.0, 14.0), "side": (90.0, 0.0)}
View = Literal["front", "three-quarter", "side"]


class Model:
    """A triangle mesh. Its arrays are views of the model's memory: changes to them are saved and
    rendered."""

    def __init__(self, core: _core.Model) -> None:
        self._core = core

    @property
    def vertices(self) -> npt.NDArray[np.float64]:
        """n x 3; px of the canvas (mm for a solid), x right, y up, z to the viewer."""
        return self._core.vertices

    @property
    def normals(self) -> npt.NDArray[np.float64]:
        """n x 3 unit vectors."""
        return self._core.normals

    @property
    def uvs(self) -> npt.NDArray[np.float64]:
        """n x 2, from 0 to 1 over the drawing, v down."""
        return self._core.uvs

    @property
    def faces(self) -> npt.NDArray[np.int32]:
        """m x 3 indices, counter-clockwise seen from outside."""
        return self._core.faces

    @property
    def parts(self) -> List[_core.ModelPart]:
        """The run of faces of each part, back to front."""
        return self._core.parts

    @property
    def solid(self) -> Optional[_core.SolidFacts]:
        """Volume and pieces of a solid; None for a surface."""
        return self._core.solid

    def save(
        self,
        path: PathLike,
        *,
        size: Optional[float] = None,
        grounded: bool = False,
        texture_size: int = 0,
        filaments: int = 4,
        slicer: Slicer = "prusa",
        ink: Optional[Ink] = None,
        ink_width: float = 1,
    ) -> None:
        """Writes a .glb, .obj, .ply, .stl, .usdz or .html file, or a .3mf file of a solid.

        The longest side is `size` mm (default: that of a solid, else 100). `grounded` puts the lowest
        point of a .glb, .obj or .ply at height 0. The texture is at most `texture_size` px on its
        longer side (0: as large as the drawing). A .3mf is painted with at most `filaments` colours for
        the given slicer. The contours of a surface become lines of their own (shell, the default for
        .glb, .usdz and .html), `ink_width` times as wide as drawn, stay in the colours (paint, for .obj
        and .ply) or are left out (none); those of a solid are as it was made. A figure on a base stands upright in files to print. Output is all-or-nothing,
        and the drawing is never overwritten."""
        self._core.save(path, size, grounded, texture_size, filaments, paint(slicer), contours(ink), ink_width)

    def render(self, view: View = "three-quarter", **options: Unpack[RenderOptions]) -> Picture:
        """Renders a picture, height x width x 4. `yaw` and `pitch` override those of the view."""
        if view not in VIEWS:
            raise ValueError(f"view must be one of {', '.join(VIEWS)}, not {view!r}")
        render = _core.RenderOptions()
        render.yaw, render.pitch = VIEWS[view]
        return self._core.render(apply(render, options))


class Relief:
    """The relief of a scene. To change it, change `scene` or options, and call `rebuild`."""

    def __init__(
        self,
        scene: Scene,
        source: _core.Source,
        warnings: List[str],
        proposed: bool,
        **options: Unpack[BuildOptions],
    ) -> None:
        self.scene = scene
        self.warnings = warnings  #: about the drawing
        self.proposed = proposed  #: whether the parts were guessed, not annotated
        self._source = source
        self._session = _core.Session(source)
        self._options = _core.BuildOptions()
        self.report = self.rebuild(**options)

    @property
    def drawing(self) -> Picture:
        """The picture on the model, height x width x 4, a view of its memory; empty if there is none."""
        return self._source.drawing

    def rebuild(self, **options: Unpack[BuildOptions]) -> _core.Report:
        """Rebuilds the relief after changes of `scene` or options. Options that are not given keep their
        values. Computes only stages whose inputs have changed."""
        apply(self._options, options)
        self.report = self._session.build(self.scene, self._options)
        return self.report

    def make_exact(self) -> None:
        """Builds from scratch, so that files have the same bytes as those of an unchanged relief."""
        self._session.make_exact()

    def model(self, *, visible: Visible = "orbit", shown: str = "relief", **options: Any) -> Model:
        """Makes the surface of whole parts (orbit), of what is visible from the front, with walls
        (relief), or of every face (all). `shown` is the height field: relief, or one of its two terms,
        inflation or shift."""
        model_options = apply(_core.ModelOptions(), options)
        model_options.visible = visibility(visible)
        return Model(self._session.model(model_options, field(shown)))

    def solid(self, **options: Unpack[SolidOptions]) -> Model:
        """Makes a closed solid in mm, to print or mill; a figure if `back` is not flat."""
        return Model(self._session.solid(apply(_core.SolidOptions(), options)))

    def maps(self, longest: Optional[int] = None) -> _core.Maps:
        """Makes maps of the front view: heights, normals and parts, `longest` px on the longer side
        (default: 2048, or of pixel art the largest multiple of its own size up to that)."""
        return self._session.maps(longest or self._source.map_side(2048))

    def save(
        self, path: PathLike, *, size: float = 100, ink: Optional[Ink] = None, ink_width: float = 1
    ) -> None:
        """Writes the same model as `relievo build`: a solid for .stl and .3mf, else whole parts. `ink` and
        `ink_width` are as of Model.save."""
        if pathlib.PurePath(path).suffix in (".stl", ".3mf"):
            self.solid(size=size, ink=ink or "none").save(path)
        else:
            self.model().save(path, size=size, ink=ink, ink_width=ink_width)

    def render(self, view: View = "three-quarter", **options: Unpack[RenderOptions]) -> Picture:
        """Renders the model; see Model.render."""
        return self.model().render(view, **options)


def build(
    drawing: Union[PathLike, Scene],
    *,
    picture: Optional[Picture] = None,
    pixel_art: Optional[bool] = None,
    **options: Unpack[BuildOptions],
) -> Relief:
    """Builds the relief of a drawing, a file that `relievo build` accepts, or of a scene with a
    `picture` of its canvas. `pixel_art` says whether the drawing keeps its pixels and colours (default:
    recognised by them). Raises Error. Ctrl-C stops it."""
    if isinstance(drawing, Scene):
        return Relief(drawing, _core.Source(picture, pixel_art), [], False, **options)
    if picture is not None:
        raise TypeError("a picture can be given only with a scene; a file has its own")
    scene, source, warnings, proposed = _core.read(drawing, pixel_art)
    return Relief(scene, source, warnings, proposed, **options)


def save_picture(path: PathLike, picture: Picture) -> None:
    """Writes an array of height x width, height x width x 3 or height x width x 4 as a PNG file."""
    _core.save_picture(path, picture)
