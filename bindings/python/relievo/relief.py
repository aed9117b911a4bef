"""A relief: built, changed, looked at, saved."""

from __future__ import annotations

import os
import pathlib
from typing import TYPE_CHECKING, Any, List, Literal, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .options import BuildOptions, RenderOptions, SolidOptions, apply, field, paint, visibility
from .scene import Scene

if TYPE_CHECKING:
    from typing_extensions import Unpack

Picture = npt.NDArray[np.uint8]
PathLike = Union[str, "os.PathLike[str]"]
Slicer = Literal["prusa", "bambu"]
Visible = Literal["relief", "orbit", "all"]

#: Degrees by which the camera moves to its right, and up.
VIEWS = {"front": (0.0, 0.0), "three-quarter": (38.0, 14.0), "side": (90.0, 0.0)}
View = Literal["front", "three-quarter", "side"]


class Model:
    """A surface of triangles. Its arrays are the model's own memory: what is written to them is what
    is saved and rendered."""

    def __init__(self, core: _core.Model) -> None:
        self._core = core

    @property
    def vertices(self) -> npt.NDArray[np.float64]:
        """n x 3; px of the canvas (mm where it is a solid), x right, y up, z to the viewer."""
        return self._core.vertices

    @property
    def normals(self) -> npt.NDArray[np.float64]:
        """n x 3, of length 1."""
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
        """Whose faces are which, back to front."""
        return self._core.parts

    @property
    def solid(self) -> Optional[_core.SolidFacts]:
        """Volume and pieces of a solid; None of a surface."""
        return self._core.solid

    def save(
        self,
        path: PathLike,
        *,
        size: Optional[float] = None,
        filaments: int = 4,
        slicer: Slicer = "prusa",
    ) -> None:
        """Writes .glb, .obj, .ply, .stl, .usdz, .html, or of a solid .3mf, painted with at most so
        many `filaments` for PrusaSlicer and its kin or for those of Bambu Studio. The longest side
        is `size` mm (a solid's own, else 100). In files to print a figure on a base is upright.
        Nothing is left half-written, and the drawing is not overwritten."""
        self._core.save(path, size, filaments, paint(slicer))

    def render(self, view: View = "three-quarter", **options: Unpack[RenderOptions]) -> Picture:
        """A picture, height x width x 4; `yaw` and `pitch` in place of the view's."""
        if view not in VIEWS:
            raise ValueError(f"view must be one of {', '.join(VIEWS)}, not {view!r}")
        render = _core.RenderOptions()
        render.yaw, render.pitch = VIEWS[view]
        return self._core.render(apply(render, options))


class Relief:
    """The relief of a scene, and the session that goes on from it: change `scene` or options, then
    `rebuild`."""

    def __init__(
        self,
        scene: Scene,
        source: _core.Source,
        warnings: List[str],
        proposed: bool,
        **options: Unpack[BuildOptions],
    ) -> None:
        self.scene = scene
        self.warnings = warnings  #: of the drawing
        self.proposed = proposed  #: the parts were guessed, not annotated
        self._source = source
        self._session = _core.Session(source)
        self._options = _core.BuildOptions()
        self.report = self.rebuild(**options)

    @property
    def drawing(self) -> Picture:
        """The picture that lies on the model, height x width x 4, its own memory; empty where there is
        none."""
        return self._source.drawing

    def rebuild(self, **options: Unpack[BuildOptions]) -> _core.Report:
        """Brings the relief up to date with `scene` and with options, which stay as they are where
        they are not named. Computes only what has changed."""
        apply(self._options, options)
        self.report = self._session.build(self.scene, self._options)
        return self.report

    def make_exact(self) -> None:
        """Builds from nothing, so that files have the bytes of a relief that was never changed."""
        self._session.make_exact()

    def model(self, *, visible: Visible = "orbit", shown: str = "relief", **options: Any) -> Model:
        """The surface: whole parts (orbit), what the front shows, with walls (relief), or every face
        (all). `shown` may be one of the two that the heights are the sum of: inflation, shift."""
        model_options = apply(_core.ModelOptions(), options)
        model_options.visible = visibility(visible)
        return Model(self._session.model(model_options, field(shown)))

    def solid(self, **options: Unpack[SolidOptions]) -> Model:
        """A closed solid to print or to mill, or with `back` a figure, in mm."""
        return Model(self._session.solid(apply(_core.SolidOptions(), options)))

    def maps(self, longest: int = 2048) -> _core.Maps:
        """Heights, normals and parts of the front view, `longest` px on the longer side."""
        return self._session.maps(longest)

    def save(self, path: PathLike, *, size: float = 100) -> None:
        """Writes the model as `relievo build` does: whole parts, what the front shows for .stl, or a
        solid for .3mf, which has nothing else."""
        ending = pathlib.PurePath(path).suffix
        if ending == ".3mf":
            self.solid(size=size).save(path)
        else:
            self.model(visible="relief" if ending == ".stl" else "orbit").save(path, size=size)

    def render(self, view: View = "three-quarter", **options: Unpack[RenderOptions]) -> Picture:
        """As Model.render."""
        return self.model().render(view, **options)


def build(
    drawing: Union[PathLike, Scene],
    *,
    picture: Optional[Picture] = None,
    **options: Unpack[BuildOptions],
) -> Relief:
    """The relief of a drawing (a file of any kind that `relievo build` takes) or of a scene, on whose
    canvas `picture` lies. Raises Error; Ctrl-C stops it."""
    if isinstance(drawing, Scene):
        return Relief(drawing, _core.Source(picture), [], False, **options)
    if picture is not None:
        raise TypeError("a picture goes with a scene; a file brings its own")
    scene, source, warnings, proposed = _core.read(drawing)
    return Relief(scene, source, warnings, proposed, **options)


def save_picture(path: PathLike, picture: Picture) -> None:
    """Writes an array of height x width, or x 3 or 4, as a PNG file."""
    _core.save_picture(path, picture)
