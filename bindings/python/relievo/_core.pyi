from os import PathLike
from typing import ClassVar, Dict, List, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from .scene import Scene

version: str

class _Enum:
    __members__: ClassVar[Dict[str, object]]

class Method(_Enum): ...
class Visibility(_Enum): ...
class Field(_Enum): ...
class BaseShape(_Enum): ...
class Ink(_Enum): ...
class BackSide(_Enum): ...
class Slicer(_Enum): ...
class Shading(_Enum): ...
class Background(_Enum): ...

class BuildOptions:
    method: Method
    vertices: int
    edge: float
    alpha0: float
    rho: float
    lambda_bnd: float
    lambda_shift: float
    glue: bool
    attach: bool

class ModelOptions:
    visible: Visibility
    rim_tolerance: float
    max_rim_levels: int

class SolidOptions:
    size: float
    back: BackSide
    base: BaseShape
    mirror: List[str]
    height: float
    detail: bool
    thickness: float
    margin: float
    corner: float
    hole: float
    ring: float
    cutter: float
    ink: Ink
    ink_width: float

class RenderOptions:
    width: int
    height: int
    yaw: float
    pitch: float
    window: Optional[Tuple[float, float, float]]
    shading: Shading
    background: Background
    light: Tuple[float, float, float]
    light_radius: float
    samples: int
    ambient_rays: int
    ink: Ink

class Report:
    """The results of a build."""

    @property
    def vertices(self) -> int: ...
    @property
    def faces(self) -> int: ...
    @property
    def equalities(self) -> int: ...
    @property
    def inequalities(self) -> int: ...
    @property
    def active(self) -> int: ...
    @property
    def max_violation(self) -> float: ...
    @property
    def worst_overlap(self) -> float: ...
    @property
    def energy(self) -> float: ...
    @property
    def converged(self) -> bool: ...
    @property
    def milliseconds(self) -> Dict[str, float]: ...
    @property
    def warnings(self) -> List[str]: ...

class ModelPart:
    """A run of faces that belong to one part."""

    @property
    def id(self) -> str: ...
    @property
    def first_face(self) -> int: ...
    @property
    def face_count(self) -> int: ...
    @property
    def hidden_count(self) -> int: ...

class SolidFacts:
    @property
    def volume(self) -> float: ...
    @property
    def pieces(self) -> int: ...
    @property
    def loose(self) -> List[str]: ...

class Source:
    def __init__(
        self, drawing: Optional[npt.NDArray[np.uint8]] = ..., pixel_art: Optional[bool] = ...
    ) -> None: ...
    @property
    def drawing(self) -> npt.NDArray[np.uint8]: ...
    def map_side(self, usual: int) -> int: ...

class Model:
    @property
    def vertices(self) -> npt.NDArray[np.float64]: ...
    @property
    def normals(self) -> npt.NDArray[np.float64]: ...
    @property
    def uvs(self) -> npt.NDArray[np.float64]: ...
    @property
    def faces(self) -> npt.NDArray[np.int32]: ...
    @property
    def parts(self) -> List[ModelPart]: ...
    @property
    def solid(self) -> Optional[SolidFacts]: ...
    def save(
        self,
        path: Union[str, PathLike[str]],
        size: Optional[float],
        grounded: bool,
        texture_size: int,
        filaments: int,
        slicer: Slicer,
        ink: Optional[Ink],
        ink_width: float,
    ) -> None: ...
    def render(self, options: RenderOptions) -> npt.NDArray[np.uint8]: ...

class Maps:
    """Maps of the front view. The arrays are views of its memory."""

    @property
    def heights(self) -> npt.NDArray[np.float32]: ...
    @property
    def normals(self) -> npt.NDArray[np.float32]: ...
    @property
    def parts(self) -> npt.NDArray[np.int32]: ...
    def save(
        self,
        *,
        normals: Union[str, PathLike[str]] = ...,
        heights: Union[str, PathLike[str]] = ...,
        parts: Union[str, PathLike[str]] = ...,
    ) -> None: ...

class Session:
    def __init__(self, source: Source) -> None: ...
    def build(self, scene: Scene, options: BuildOptions) -> Report: ...
    def make_exact(self) -> None: ...
    def model(self, options: ModelOptions, field: Field) -> Model: ...
    def solid(self, options: SolidOptions) -> Model: ...
    def maps(self, longest: int) -> Maps: ...

def read(path: Union[str, PathLike[str]], pixel_art: Optional[bool]) -> Tuple[Scene, Source, List[str], bool]: ...
def save_picture(path: Union[str, PathLike[str]], picture: npt.NDArray[np.uint8]) -> None: ...
