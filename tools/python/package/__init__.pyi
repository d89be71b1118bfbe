# Made by tools/python/stubs.py.
import dataclasses
import os
from typing import Callable, Literal, Mapping, Sequence

import numpy as np

__version__: str
Progress = Callable[[str, float | None], bool | None]

class Error(Exception):
    exit_code: int

class Cancelled(Error): ...

class InternalFault(Error): ...

class LimitError(Error): ...

class NothingToDo(Error): ...

class ReadError(Error): ...

class UsageError(Error, ValueError): ...

class WriteError(Error): ...

def decimate_options() -> list[dict]:
    """The options of `decimate`, which are those of `aomd decimate`.

    Each is a dictionary: `name` (of the keyword argument), `flag` (whether it is True or False),
    `value` (what it takes, such as "DEG"), `default`, `group` and `help`.
    """

class Mesh:
    """Vertices and what lies between them, as a file lists it. Never changes once it is made.

    Arrays that it hands out look into it: they cost nothing, and cannot be written to.
    """

    def __init__(self, vertices, faces=None, *, regions=None, edges=None, classes: Mapping[str, np.ndarray] | None=None):
        """From arrays, which are copied once.

        vertices: shape (n, 3). faces: shape (m, 3), triangles, or (m, 4), quads. regions: shape
        (m, 4) tetrahedra, 5 pyramids, 6 prisms, 8 hexahedra. edges: shape (m, 2). Several shapes
        are a list of such arrays. classes: by "vertices", "edges", "faces" and "regions" what each
        lies on, shape (m,), tags of model entities of that dimension, or (m, 2), their dimension
        and tag (-1, 0 for none). Raises ValueError for other shapes, for coordinates that are not
        finite and for vertices that there are not.
        """

    @classmethod
    def from_bytes(cls, data: bytes, name: str='mesh') -> Mesh:
        """From the bytes of a file; `name` stands in messages. Raises as `read` does."""

    def to_bytes(self, format: str, *, binary: bool | None=None) -> bytes:
        """The bytes of a file: "ply", "obj", "off", "stl", "glb", "gltf", "msh", "mesh", "vtk",
        "vtu" or "su2".

        Raises WriteError for what the format cannot hold, ValueError for another format.
        """

    @property
    def vertices(self) -> np.ndarray:
        """Coordinates: float64, shape (n, 3)."""

    @property
    def faces(self) -> np.ndarray:
        """Vertices of the listed faces: uint32, shape (m, 3), or (m, 4) where all are quads.

        Raises ValueError where triangles and quads are mixed: see `by_shape`.
        """

    @property
    def regions(self) -> np.ndarray:
        """Vertices of the regions: uint32, shape (m, 4) for tetrahedra. Raises as `faces` does."""

    @property
    def edges(self) -> np.ndarray:
        """Vertices of the listed edges: uint32, shape (m, 2)."""

    def by_shape(self, kind: str='faces') -> dict[str, np.ndarray]:
        """Vertices of "faces" or "regions" by the name of their shape: uint32, shape (m, k).

        Copies. Raises ValueError for another kind.
        """

    def count(self, kind: str) -> int:
        """How many "vertices", "edges", "faces" or "regions" are listed."""

    def classes(self, kind: str) -> np.ndarray | None:
        """What each lies on: int32, shape (m, 2), dimension and tag of a model entity.

        -1 and 0: nothing. None where the mesh says nothing of that kind.
        """

    def attributes(self, kind: str='vertices') -> dict[str, np.ndarray]:
        """Attached numbers by name: float64 or int64, shape (m,) or (m, components).

        kind "corners": one row for each corner of each face, in the order of the faces.
        """

    def with_attribute(self, name: str, values, kind: str='vertices') -> Mesh:
        """A copy with these numbers attached, in the place of any of that name.

        values: shape (m,) or (m, components), one row for each entity of `kind`, or
        for each corner of each face ("corners"). Raises ValueError
        where that is not so.
        """

    def without_attribute(self, name: str, kind: str='vertices') -> Mesh:
        """A copy without the numbers of that name."""

    def write(self, file: str | os.PathLike, *, binary: bool | None=None, msh2: bool=False) -> list[str]:
        """Writes a file as `aomd.write` does."""

    def _repr_png_(self) -> bytes:
        ...

@dataclasses.dataclass(frozen=True)
class Decimated:
    """What `decimate` made."""
    mesh: Mesh
    report: dict
    notes: list[str]
    missed: str

@dataclasses.dataclass(frozen=True)
class Repaired:
    """What `repair` made."""
    mesh: Mesh
    done: list[dict]
    left: list[dict]

@dataclasses.dataclass(frozen=True)
class Classified:
    """What `classify` made."""
    mesh: Mesh
    model_vertices: int
    model_edges: int
    model_faces: int
    given: bool
    notes: list[str]

def read(file: str | os.PathLike) -> Mesh:
    """Reads a mesh; its content decides the format, then its name.

    The mesh's `notes` say what was done to it. Raises ReadError with the line or the byte for what
    cannot be read, LimitError for what is too large.
    """

def write(file: str | os.PathLike, mesh: Mesh, *, binary: bool | None=None, msh2: bool=False) -> list[str]:
    """Writes a mesh whole or not at all; the extension chooses the format. Returns notes.

    binary: where the format has both; None is what suits it. msh2: MSH 2.2 instead of 4.1. Raises
    WriteError for what the format cannot hold and for a place that cannot be written.
    """

def decimate(mesh: Mesh, *, progress: Progress | None=None, target_faces: int | str | None=None, target_tets: int | str | None=None, target_error: float | None=None, reach: bool | None=None, factor: float | None=None, coarsest: bool | None=None, spacing: str | os.PathLike | np.ndarray | None=None, gradation: float | None=None, strategy: Literal['paper', 'quality'] | None=None, regularity: float | None=None, feature_angle: float | str | None=None, seams: Literal['keep', 'ignore'] | None=None, attributes: str | Sequence[str] | None=None, improve: int | None=None, exchange: bool | None=None, no_swap: bool | None=None, no_smooth: bool | None=None, snap: Literal['none', 'model'] | None=None, model: str | os.PathLike | None=None, repair: bool | None=None, triangulate: bool | None=None, split_to_tets: bool | None=None, weld: bool | float | str | None=None, without: str | Sequence[str] | None=None, threads: int | None=None, angle: float | None=None, min_angle: float | None=None, min_dihedral: float | None=None, max_distance: float | None=None, no_intersections: bool | None=None, volume: Literal['keep', 'free'] | None=None, topology: Literal['safe', 'paper'] | None=None, keep: str | os.PathLike | np.ndarray | Sequence[int] | None=None, only: str | os.PathLike | None=None, report: str | os.PathLike | None=None, journal: str | os.PathLike | None=None, strict: bool | None=None) -> Decimated:
    """Makes a mesh coarser as `aomd decimate` does, with the same options by name.

    target_faces="10%" is --target-faces 10%, no_swap=True is --no-swap; `decimate_options()` lists
    them. `keep` also takes an array of vertices, shape (k,), and `spacing` one of lengths, shape
    (n,). progress(phase, done) is called about ten times a second, done in [0, 1] or None; where it
    returns False, Cancelled is raised. Ctrl-C ends it too. Other threads run meanwhile.

    Raises TypeError for an option that there is not, UsageError for a value that makes no sense,
    LimitError and ReadError for a mesh that cannot be decimated, NothingToDo for a volume without
    tetrahedra, and with strict=True where the target is missed.
    """

def info(mesh: Mesh) -> dict:
    """Counts, topology, quality and memory: what `aomd info --json` prints."""

def check(mesh: Mesh, *, unused: bool=False, require: Sequence[str]=()) -> dict:
    """What is wrong with a mesh, by name: what `aomd check --json` prints.

    "findings" is empty for a sound mesh; "missing" names those of `require` ("closed", "manifold",
    "clean", ...) that a surface is not. unused: also what nothing uses. Raises UsageError for
    another word.
    """

def compare(original: Mesh, result: Mesh, *, samples: int=500000, threads: int=0, max_distance: float | None=None, max_rms: float | None=None, max_flips: int | None=None, max_intersections: int | None=None, same_topology: bool=False) -> dict:
    """Distances, normals and topology between two meshes: what `aomd compare --json` prints.

    Distances are in percent of the diagonal of the original's box, measured at `samples` points of
    each surface and at all vertices. "objections" says what is beyond the limits that are given.
    Raises ReadError for a mesh without faces.
    """

def repair(mesh: Mesh, *, weld: bool | float=False, repeated_vertices: bool=True, repeated_faces: bool=True, opposite_faces: bool=True, orient: bool=True, split: bool=True, zero_area: bool=True, min_piece: float=0, drop_unused: bool=False) -> Repaired:
    """Mends what is safe to mend in a surface, as `aomd repair` does.

    weld: True joins vertices at the same position, a number border vertices within that length too.
    min_piece: pieces smaller than this go, percent of the diagonal. Raises LimitError for a volume.
    """

def classify(mesh: Mesh, *, angle: float | None=20, replace: bool=False) -> Classified:
    """Says what each entity lies on, from the angles between faces, as `aomd classify` does.

    angle: edges whose faces meet at more than these degrees become model edges; None: none do.
    replace: forgets what the mesh said before. Raises ReadError where it cannot be classified.
    """

def split_to_tets(mesh: Mesh) -> Mesh:
    """Cuts hexahedra, prisms and pyramids into tetrahedra that match, and quads beside them."""

def self_intersections(mesh: Mesh) -> np.ndarray:
    """Pairs of faces that cut each other: uint32, shape (k, 2), ascending. Exact."""

def sample(name: str, size: int=0) -> Mesh:
    """A generated mesh; size 0 is its own. Raises ValueError for a name that there is not."""

def samples() -> dict[str, str]:
    """The names of generated meshes, and what each is."""

def render(mesh: Mesh, *, size: tuple[int, int]=(800, 600), camera: str='iso', color: str='classification', commands: Sequence[str]=(), transparent: bool=False) -> np.ndarray:
    """A picture, drawn without a display: uint8, shape (height, width, 4), rows from the top, RGBA.

    size: width and height in pixels. camera and color are what follows these words in
    docs/COMMANDS.md, such as "front" or "azimuth=30 elevation=20", and "quality" or "none";
    `commands` are more lines of it. transparent: no background. Raises UsageError for what is no
    command, LimitError for other sizes and where nothing can draw.
    """

def to_png(picture: np.ndarray) -> bytes:
    """The bytes of a PNG of a picture of shape (height, width, 4). Raises ValueError for others."""

def image_difference(first: np.ndarray, second: np.ndarray) -> dict:
    """How far two pictures of shape (height, width, 4) are from each other.

    "same_size", "ssim" (structural similarity: 1 is equal), "differing_pixels" and
    "largest_channel_difference" (0 to 255).
    """

def difference_picture(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Where the second picture departs from the first: grey, with differences in red.

    Both have the shape (height, width, 4); so does the result, in the frame of the larger one.
    """

def judge_pictures(baseline: np.ndarray, result: np.ndarray, *, threshold: float=0.98, largest: int=48, share: float=0.0005, noise: int=2, edges: bool=True, masks: Sequence[tuple[int, int, int, int]]=()) -> dict:
    """Whether a picture is still its baseline, as a person would say (docs/REGRESSION.md).

    Both have the shape (height, width, 4). threshold: least similarity of a tile of 32x32 pixels,
    with 1 nothing is forgiven. largest: difference of a pixel, of 255. share: how many pixels may
    differ. noise: differences that are none. edges: single pixels along edges are forgiven. masks:
    (left, top, width, height) of what is not judged.

    "same", "why" (one line; empty where they are the same), "worst_tile" (its similarity), "tile"
    (left, top, width, height), "largest", "largest_at", "differing" and "judged" (pixels).
    """

def read_png(file: str | os.PathLike) -> np.ndarray:
    """A picture from a PNG: uint8, shape (height, width, 4). Raises ReadError, LimitError."""

def write_png(file: str | os.PathLike, picture: np.ndarray) -> None:
    """Writes a picture of shape (height, width, 4) as a PNG, whole or not at all.

    Raises WriteError where it cannot be written, ValueError for another shape.
    """

class Database:
    """A mesh that can be asked and changed: entities, adjacencies T(I,J), and a history.

    Dimensions are 0 vertices, 1 edges, 2 faces, 3 regions; an entity is its dimension and its id.
    Ids stay while the entity lives. Raises IndexError for an entity that there is not. For one
    thread at a time.
    """

    def __init__(self, mesh: Mesh):
        """Holds what the mesh lists. Copies it."""

    def to_mesh(self) -> Mesh:
        """What it holds now, ids made consecutive."""

    def count(self, dimension: int) -> int:
        """How many entities there are."""

    def ids(self, dimension: int) -> np.ndarray:
        """Ids of the entities, ascending: uint32, shape (count,)."""

    def positions(self) -> np.ndarray:
        """Coordinates by id: float64, shape (largest id + 1, 3); 0 where no vertex is. A copy."""

    def tensor(self) -> np.ndarray:
        """Which T(I,J) are stored: bool, shape (4, 4)."""

    def store(self, i: int, j: int) -> None:
        """Stores T(i,j) from now on; edges and faces that it needs are made.

        Raises RuntimeError where a history would have to hold them, ValueError on the diagonal.
        """

    def release(self, i: int, j: int) -> None:
        """Lets go of T(i,j). Raises RuntimeError where it is what defines the entities."""

    def explain(self, i: int, j: int) -> str:
        """How T(i,j) is answered now, or what to store."""

    def adjacent(self, dimension: int, id: int, level: int) -> np.ndarray:
        """Entities of `level` at an entity: uint32; lower ones in the order of its template.

        Raises RuntimeError where nothing that is stored leads there, with what to store.
        """

    def relation(self, i: int, j: int) -> tuple[np.ndarray, np.ndarray]:
        """All rows of T(i,j): offsets, uint64, shape (largest id + 2,), and entries, uint32.

        The row of id k is entries[offsets[k]:offsets[k + 1]]. Raises as `adjacent` does.
        """

    def vertices_of(self, dimension: int, id: int) -> np.ndarray:
        """Vertices of an entity in the order of its template: uint32."""

    def find(self, dimension: int, vertices: Sequence[int]) -> int | None:
        """The edge, face or region on just these vertices, in any order; None: there is none."""

    def users(self, dimension: int, id: int) -> list[tuple[int, int]]:
        """The higher entities that use an entity, as (dimension, id)."""

    def classification(self, dimension: int, id: int) -> tuple[int, int] | None:
        """The model entity that an entity lies on, as (dimension, tag); None: nothing."""

    def memory(self) -> tuple[int, int]:
        """Bytes of the entities and of the adjacencies."""

    def verify(self, *, unused: bool=False) -> list[tuple[str, tuple[int, int], str]]:
        """What is inconsistent: name, entity and a sentence each. Empty for a sound database."""

    def classify(self, *, angle: float | None=20, replace: bool=False) -> dict:
        """Says what each entity lies on, as `aomd.classify` does. Makes all edges."""

    def create_vertex(self, position: Sequence[float], model: tuple[int, int] | None=None) -> int:
        """A new vertex, on a model entity (dimension, tag). Returns its id."""

    def create(self, dimension: int, vertices: Sequence[int], model: tuple[int, int] | None=None) -> int:
        """A new edge, face or region on these vertices, with its sides. Returns its id.

        Raises ValueError where they form none, or where there is one already.
        """

    def destroy(self, dimension: int, id: int, *, with_users: bool=False) -> None:
        """Deletes an entity. Raises RuntimeError, naming its users, unless these go along."""

    def move(self, vertex: int, position: Sequence[float]) -> None:
        """Moves a vertex to x, y, z."""

    def set_classification(self, dimension: int, id: int, model: tuple[int, int] | None) -> None:
        """Puts an entity on a model entity (dimension, tag).

        Raises ValueError for one of lower dimension than the entity.
        """

    def record(self) -> None:
        """From now on every edit is a step of the history."""

    @property
    def steps(self) -> int:
        """How many steps the history has. Raises RuntimeError where nothing is recorded."""

    @property
    def cursor(self) -> int:
        """How many of them are applied."""

    def step(self, index: int) -> tuple[str, tuple[int, int] | None]:
        """What a step was: its kind ("collapse", "swap", ...), and the entity that it was about.

        None for the entity of a single edit. Raises IndexError for a step that there is not.
        """

    def undo(self) -> bool:
        """Takes the last step back; False where there is none. Ids and bits are as before."""

    def redo(self) -> bool:
        """Does the next step again; False where there is none."""

    def seek(self, step: int) -> None:
        """Undoes or redoes until so many steps are applied."""

class Decimation:
    """Decimates a Database step by step, and says why an edge stays."""

    def __init__(self, database: Database, *, target_faces: int | str | None=None, target_tets: int | str | None=None, target_error: float | None=None, reach: bool | None=None, factor: float | None=None, coarsest: bool | None=None, spacing: str | os.PathLike | np.ndarray | None=None, gradation: float | None=None, strategy: Literal['paper', 'quality'] | None=None, regularity: float | None=None, feature_angle: float | str | None=None, seams: Literal['keep', 'ignore'] | None=None, attributes: str | Sequence[str] | None=None, improve: int | None=None, exchange: bool | None=None, no_swap: bool | None=None, no_smooth: bool | None=None, snap: Literal['none', 'model'] | None=None, model: str | os.PathLike | None=None, repair: bool | None=None, triangulate: bool | None=None, split_to_tets: bool | None=None, weld: bool | float | str | None=None, without: str | Sequence[str] | None=None, threads: int | None=None, angle: float | None=None, min_angle: float | None=None, min_dihedral: float | None=None, max_distance: float | None=None, no_intersections: bool | None=None, volume: Literal['keep', 'free'] | None=None, topology: Literal['safe', 'paper'] | None=None, keep: str | os.PathLike | np.ndarray | Sequence[int] | None=None, only: str | os.PathLike | None=None, report: str | os.PathLike | None=None, journal: str | os.PathLike | None=None, strict: bool | None=None):
        """With the options of `decimate` that say how (see `decimate_options`).

        The database must be classified. Raises ValueError where it cannot be decimated, and as
        `decimate` does.
        """

    def step(self) -> tuple[str, tuple[int, int]] | None:
        """One operation: its kind, and the entity that it was about; None when all is done."""

    def sweep(self) -> int:
        """To the end of the present sweep of collapses. Returns how many there were."""

    def swap(self) -> int:
        """One pass of swaps. Returns how many there were."""

    def smooth(self) -> int:
        """One pass of smoothing. Returns how many vertices moved."""

    def run(self, *, progress: Progress | None=None, seconds: float | None=None) -> bool:
        """Until all is done, or for about so many seconds. Returns whether all is done.

        progress is called, and may end it, as in `decimate`; what was done until then stays.
        """

    @property
    def done(self) -> bool:
        """Whether nothing more goes."""

    @property
    def phase(self) -> str:
        """What comes next: "collapse", "swap", "smooth" or "done"."""

    @property
    def progress(self) -> float:
        """A guess in [0, 1]."""

    def judge(self, edge: int) -> dict:
        """What the run would say of an edge now.

        "accepted"; "reason", a word, or None; "number", the angle in degrees or the length that
        decided; "entity" that decided, as (dimension, id), or None; "deleted", the vertex that
        would go, or None.
        """

    def why(self, edge: int) -> list[str]:
        """The same in sentences, one for each way to collapse the edge."""

    def why_swap(self, edge: int) -> str | None:
        """What swapping an edge would come to; None while the quality strategy collapses."""

    def why_move(self, vertex: int) -> str | None:
        """What smoothing a vertex would come to; None while the quality strategy collapses."""

    def edges_left(self) -> dict[str, int]:
        """How many edges each reason keeps, most first."""

    def why_stopped(self) -> str:
        """The same in a sentence."""

    @property
    def sweeps(self) -> list[dict]:
        """What each sweep did and refused: "sweeps" of a report."""
