"""Meshes of triangles and of tetrahedra: read, made coarser, measured, repaired, drawn.

`Mesh` is what a file holds, as NumPy arrays. `decimate` makes one coarser; `Database` and
`Decimation` do the same step by step, with undo and with reasons. Lengths are in the units of the
mesh, angles in degrees, vertices are counted from 0. What fails raises an `Error` with the words
that the program `aomd` prints; its `exit_code` is that of the program.
"""

from __future__ import annotations

import dataclasses
import json
import os
from typing import Callable, Iterable, Mapping, Sequence

import numpy as np

from . import _aomd
from ._aomd import (Cancelled, Error, InternalFault, LimitError, NothingToDo, ReadError, UsageError,
                    WriteError)
from .options import decimate_options, told as _told

__version__ = ".".join(map(str, _aomd.version))

__all__ = [
    "Cancelled", "Classified", "Database", "Decimated", "Decimation", "Error", "InternalFault",
    "LimitError", "Mesh", "NothingToDo", "ReadError", "Repaired", "UsageError", "WriteError",
    "check", "classify", "compare", "decimate", "decimate_options", "difference_picture",
    "image_difference", "info", "judge_pictures", "read", "read_png", "render", "repair", "sample",
    "samples", "self_intersections", "split_to_tets",
    "to_png", "write", "write_png",
]

Progress = Callable[[str, "float | None"], "bool | None"]


class Mesh:
    """Vertices and what lies between them, as a file lists it. Never changes once it is made.

    Arrays that it hands out look into it: they cost nothing, and cannot be written to.
    """

    __slots__ = ("_data", "notes")

    def __init__(self, vertices, faces=None, *, regions=None, edges=None,
                 classes: Mapping[str, np.ndarray] | None = None):
        """From arrays, which are copied once.

        vertices: shape (n, 3). faces: shape (m, 3), triangles, or (m, 4), quads. regions: shape
        (m, 4) tetrahedra, 5 pyramids, 6 prisms, 8 hexahedra. edges: shape (m, 2). Several shapes
        are a list of such arrays. classes: by "vertices", "edges", "faces" and "regions" what each
        lies on, shape (m,), tags of model entities of that dimension, or (m, 2), their dimension
        and tag (-1, 0 for none). Raises ValueError for other shapes, for coordinates that are not
        finite and for vertices that there are not.
        """
        self._data = _aomd.MeshData(np.asarray(vertices), _arrays(faces), _arrays(regions),
                                    _arrays(edges), dict(classes or {}))
        self.notes: list[str] = []

    @classmethod
    def _of(cls, data, notes: Iterable[str] = ()) -> Mesh:
        mesh = cls.__new__(cls)
        mesh._data = data
        mesh.notes = list(notes)
        return mesh

    @classmethod
    def from_bytes(cls, data: bytes, name: str = "mesh") -> Mesh:
        """From the bytes of a file; `name` stands in messages. Raises as `read` does."""
        return cls._of(*_aomd.from_bytes(data, name))

    def to_bytes(self, format: str, *, binary: bool | None = None) -> bytes:
        """The bytes of a file: "ply", "obj", "off", "stl", "glb", "gltf", "msh", "mesh", "vtk",
        "vtu" or "su2".

        Raises WriteError for what the format cannot hold, ValueError for another format.
        """
        return _aomd.to_bytes(self._data, format, binary)[0]

    @property
    def vertices(self) -> np.ndarray:
        """Coordinates: float64, shape (n, 3)."""
        return self._data.vertices

    @property
    def faces(self) -> np.ndarray:
        """Vertices of the listed faces: uint32, shape (m, 3), or (m, 4) where all are quads.

        Raises ValueError where triangles and quads are mixed: see `by_shape`.
        """
        return self._data.corners(2)

    @property
    def regions(self) -> np.ndarray:
        """Vertices of the regions: uint32, shape (m, 4) for tetrahedra. Raises as `faces` does."""
        return self._data.corners(3)

    @property
    def edges(self) -> np.ndarray:
        """Vertices of the listed edges: uint32, shape (m, 2)."""
        return self._data.corners(1)

    def by_shape(self, kind: str = "faces") -> dict[str, np.ndarray]:
        """Vertices of "faces" or "regions" by the name of their shape: uint32, shape (m, k).

        Copies. Raises ValueError for another kind.
        """
        return self._data.by_shape(kind)

    def count(self, kind: str) -> int:
        """How many "vertices", "edges", "faces" or "regions" are listed."""
        return self._data.count(kind)

    def classes(self, kind: str) -> np.ndarray | None:
        """What each lies on: int32, shape (m, 2), dimension and tag of a model entity.

        -1 and 0: nothing. None where the mesh says nothing of that kind.
        """
        return self._data.classes(kind)

    def attributes(self, kind: str = "vertices") -> dict[str, np.ndarray]:
        """Attached numbers by name: float64 or int64, shape (m,) or (m, components).

        kind "corners": one row for each corner of each face, in the order of the faces.
        """
        return self._data.attributes(kind)

    def with_attribute(self, name: str, values, kind: str = "vertices") -> Mesh:
        """A copy with these numbers attached, in the place of any of that name.

        values: shape (m,) or (m, components), one row for each entity of `kind`, or
        for each corner of each face ("corners"). Raises ValueError
        where that is not so.
        """
        return Mesh._of(self._data.with_attribute(name, np.asarray(values), kind), self.notes)

    def without_attribute(self, name: str, kind: str = "vertices") -> Mesh:
        """A copy without the numbers of that name."""
        return Mesh._of(self._data.without_attribute(name, kind), self.notes)

    def write(self, file: str | os.PathLike, *, binary: bool | None = None,
              msh2: bool = False) -> list[str]:
        """Writes a file as `aomd.write` does."""
        return write(file, self, binary=binary, msh2=msh2)

    def __eq__(self, other) -> bool:
        return isinstance(other, Mesh) and self._data == other._data

    __hash__ = None

    def __repr__(self) -> str:
        return repr(self._data)

    def _repr_png_(self) -> bytes:
        return to_png(render(self, size=(640, 480)))


def _arrays(values):
    if values is None:
        return None
    listed = isinstance(values, (list, tuple)) and len(values) > 0
    if listed and isinstance(values[0], np.ndarray) and values[0].ndim == 2:
        return list(values)
    return np.asarray(values)


@dataclasses.dataclass(frozen=True)
class Decimated:
    """What `decimate` made."""

    mesh: Mesh
    report: dict  #: what `aomd decimate --report` writes (docs/COMMAND_LINE.md)
    notes: list[str]  #: what `aomd decimate` would say beside it
    missed: str  #: why the target was missed by more than 1 percent; empty where it was not


@dataclasses.dataclass(frozen=True)
class Repaired:
    """What `repair` made."""

    mesh: Mesh
    done: list[dict]  #: what was mended: name, count, text and the first few entities
    left: list[dict]  #: what could not be mended safely


@dataclasses.dataclass(frozen=True)
class Classified:
    """What `classify` made."""

    mesh: Mesh
    model_vertices: int
    model_edges: int
    model_faces: int
    given: bool  #: the mesh said what it lies on: the angle had no say
    notes: list[str]


def read(file: str | os.PathLike) -> Mesh:
    """Reads a mesh; its content decides the format, then its name.

    The mesh's `notes` say what was done to it. Raises ReadError with the line or the byte for what
    cannot be read, LimitError for what is too large.
    """
    return Mesh._of(*_aomd.read(os.fspath(file)))


def write(file: str | os.PathLike, mesh: Mesh, *, binary: bool | None = None,
          msh2: bool = False) -> list[str]:
    """Writes a mesh whole or not at all; the extension chooses the format. Returns notes.

    binary: where the format has both; None is what suits it. msh2: MSH 2.2 instead of 4.1. Raises
    WriteError for what the format cannot hold and for a place that cannot be written.
    """
    return _aomd.write(os.fspath(file), mesh._data, binary, msh2)


def decimate(mesh: Mesh, *, progress: Progress | None = None, **options) -> Decimated:
    """Makes a mesh coarser as `aomd decimate` does, with the same options by name.

    target_faces="10%" is --target-faces 10%, no_swap=True is --no-swap; `decimate_options()` lists
    them. `keep` also takes an array of vertices, shape (k,), and `spacing` one of lengths, shape
    (n,). progress(phase, done) is called about ten times a second, done in [0, 1] or None; where it
    returns False, Cancelled is raised. Ctrl-C ends it too. Other threads run meanwhile.

    Raises TypeError for an option that there is not, UsageError for a value that makes no sense,
    LimitError and ReadError for a mesh that cannot be decimated, NothingToDo for a volume without
    tetrahedra, and with strict=True where the target is missed.
    """
    words, keep, spacing = _told("decimate", dict(options))
    data, report, notes, missed = _aomd.decimate(mesh._data, words, keep, spacing, progress)
    if missed and options.get("strict"):
        raise NothingToDo(missed)
    return Decimated(Mesh._of(data, notes), json.loads(report), notes, missed)


def info(mesh: Mesh) -> dict:
    """Counts, topology, quality and memory: what `aomd info --json` prints."""
    return json.loads(_aomd.info(mesh._data))


def check(mesh: Mesh, *, unused: bool = False, require: Sequence[str] = ()) -> dict:
    """What is wrong with a mesh, by name: what `aomd check --json` prints.

    "findings" is empty for a sound mesh; "missing" names those of `require` ("closed", "manifold",
    "clean", ...) that a surface is not. unused: also what nothing uses. Raises UsageError for
    another word.
    """
    return json.loads(_aomd.check(mesh._data, unused, list(require)))


def compare(original: Mesh, result: Mesh, *, samples: int = 500_000, threads: int = 0,
            max_distance: float | None = None, max_rms: float | None = None,
            max_flips: int | None = None, max_intersections: int | None = None,
            same_topology: bool = False) -> dict:
    """Distances, normals and topology between two meshes: what `aomd compare --json` prints.

    Distances are in percent of the diagonal of the original's box, measured at `samples` points of
    each surface and at all vertices. "objections" says what is beyond the limits that are given.
    Raises ReadError for a mesh without faces.
    """
    arguments = _aomd.CompareArguments(samples, threads, max_distance, max_rms, max_flips,
                                       max_intersections, same_topology)
    return json.loads(_aomd.compare(original._data, result._data, arguments))


def repair(mesh: Mesh, *, weld: bool | float = False, repeated_vertices: bool = True,
           repeated_faces: bool = True, opposite_faces: bool = True, orient: bool = True,
           split: bool = True, zero_area: bool = True, min_piece: float = 0,
           drop_unused: bool = False) -> Repaired:
    """Mends what is safe to mend in a surface, as `aomd repair` does.

    weld: True joins vertices at the same position, a number border vertices within that length too.
    min_piece: pieces smaller than this go, percent of the diagonal. Raises LimitError for a volume.
    """
    options = _aomd.RepairOptions()
    options.weld, options.weld_tolerance = weld is not False, float(weld if weld is not True else 0)
    options.repeated_vertices, options.repeated_faces = repeated_vertices, repeated_faces
    options.opposite_faces, options.orient, options.split = opposite_faces, orient, split
    options.zero_area, options.min_piece_pct = zero_area, min_piece
    options.drop_unused = drop_unused
    data, report = _aomd.repair(mesh._data, options)
    return Repaired(Mesh._of(data), **json.loads(report))


def classify(mesh: Mesh, *, angle: float | None = 20, replace: bool = False) -> Classified:
    """Says what each entity lies on, from the angles between faces, as `aomd classify` does.

    angle: edges whose faces meet at more than these degrees become model edges; None: none do.
    replace: forgets what the mesh said before. Raises ReadError where it cannot be classified.
    """
    data, counts, notes = _aomd.classify(mesh._data, angle, replace)
    return Classified(Mesh._of(data, notes), **counts, notes=notes)


def split_to_tets(mesh: Mesh) -> Mesh:
    """Cuts hexahedra, prisms and pyramids into tetrahedra that match, and quads beside them."""
    data, text = _aomd.split_to_tets(mesh._data)
    return Mesh._of(data, ["cut " + text] if text else [])


def self_intersections(mesh: Mesh) -> np.ndarray:
    """Pairs of faces that cut each other: uint32, shape (k, 2), ascending. Exact."""
    return _aomd.self_intersections(mesh._data)


def sample(name: str, size: int = 0) -> Mesh:
    """A generated mesh; size 0 is its own. Raises ValueError for a name that there is not."""
    return Mesh._of(_aomd.sample(name, size))


def samples() -> dict[str, str]:
    """The names of generated meshes, and what each is."""
    return dict(_aomd.samples())


def render(mesh: Mesh, *, size: tuple[int, int] = (800, 600), camera: str = "iso",
           color: str = "classification", commands: Sequence[str] = (),
           transparent: bool = False) -> np.ndarray:
    """A picture, drawn without a display: uint8, shape (height, width, 4), rows from the top, RGBA.

    size: width and height in pixels. camera and color are what follows these words in
    docs/COMMANDS.md, such as "front" or "azimuth=30 elevation=20", and "quality" or "none";
    `commands` are more lines of it. transparent: no background. Raises UsageError for what is no
    command, LimitError for other sizes and where nothing can draw.
    """
    lines = [f"color {color}", f"camera {camera}", *commands]
    return _aomd.render(mesh._data, int(size[0]), int(size[1]), lines, transparent)


def to_png(picture: np.ndarray) -> bytes:
    """The bytes of a PNG of a picture of shape (height, width, 4). Raises ValueError for others."""
    return _aomd.to_png(np.ascontiguousarray(picture, dtype=np.uint8))


def image_difference(first: np.ndarray, second: np.ndarray) -> dict:
    """How far two pictures of shape (height, width, 4) are from each other.

    "same_size", "ssim" (structural similarity: 1 is equal), "differing_pixels" and
    "largest_channel_difference" (0 to 255).
    """
    return _aomd.image_difference(first, second)


def difference_picture(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Where the second picture departs from the first: grey, with differences in red.

    Both have the shape (height, width, 4); so does the result, in the frame of the larger one.
    """
    return _aomd.difference_picture(first, second)


def judge_pictures(baseline: np.ndarray, result: np.ndarray, *, threshold: float = 0.98,
                   largest: int = 48, share: float = 0.0005, noise: int = 2, edges: bool = True,
                   masks: Sequence[tuple[int, int, int, int]] = ()) -> dict:
    """Whether a picture is still its baseline, as a person would say (docs/REGRESSION.md).

    Both have the shape (height, width, 4). threshold: least similarity of a tile of 32x32 pixels,
    with 1 nothing is forgiven. largest: difference of a pixel, of 255. share: how many pixels may
    differ. noise: differences that are none. edges: single pixels along edges are forgiven. masks:
    (left, top, width, height) of what is not judged.

    "same", "why" (one line; empty where they are the same), "worst_tile" (its similarity), "tile"
    (left, top, width, height), "largest", "largest_at", "differing" and "judged" (pixels).
    """
    return _aomd.judge_pictures(baseline, result, threshold, largest, share, noise, edges,
                                [tuple(map(int, mask)) for mask in masks])


def read_png(file: str | os.PathLike) -> np.ndarray:
    """A picture from a PNG: uint8, shape (height, width, 4). Raises ReadError, LimitError."""
    return _aomd.read_png(os.fspath(file))


def write_png(file: str | os.PathLike, picture: np.ndarray) -> None:
    """Writes a picture of shape (height, width, 4) as a PNG, whole or not at all.

    Raises WriteError where it cannot be written, ValueError for another shape.
    """
    _aomd.write_png(os.fspath(file), picture)


class Database:
    """A mesh that can be asked and changed: entities, adjacencies T(I,J), and a history.

    Dimensions are 0 vertices, 1 edges, 2 faces, 3 regions; an entity is its dimension and its id.
    Ids stay while the entity lives. Raises IndexError for an entity that there is not. For one
    thread at a time.
    """

    def __init__(self, mesh: Mesh):
        """Holds what the mesh lists. Copies it."""
        self._held = _aomd.Database(mesh._data)

    def to_mesh(self) -> Mesh:
        """What it holds now, ids made consecutive."""
        return Mesh._of(self._held.to_data())

    def count(self, dimension: int) -> int:
        """How many entities there are."""
        return self._held.count(dimension)

    def ids(self, dimension: int) -> np.ndarray:
        """Ids of the entities, ascending: uint32, shape (count,)."""
        return self._held.ids(dimension)

    def positions(self) -> np.ndarray:
        """Coordinates by id: float64, shape (largest id + 1, 3); 0 where no vertex is. A copy."""
        return self._held.positions()

    def tensor(self) -> np.ndarray:
        """Which T(I,J) are stored: bool, shape (4, 4)."""
        return np.array(self._held.tensor(), dtype=bool)

    def store(self, i: int, j: int) -> None:
        """Stores T(i,j) from now on; edges and faces that it needs are made.

        Raises RuntimeError where a history would have to hold them, ValueError on the diagonal.
        """
        self._held.store(i, j)

    def release(self, i: int, j: int) -> None:
        """Lets go of T(i,j). Raises RuntimeError where it is what defines the entities."""
        self._held.release(i, j)

    def explain(self, i: int, j: int) -> str:
        """How T(i,j) is answered now, or what to store."""
        return self._held.explain(i, j)

    def adjacent(self, dimension: int, id: int, level: int) -> np.ndarray:
        """Entities of `level` at an entity: uint32; lower ones in the order of its template.

        Raises RuntimeError where nothing that is stored leads there, with what to store.
        """
        return self._held.adjacent(dimension, id, level)

    def relation(self, i: int, j: int) -> tuple[np.ndarray, np.ndarray]:
        """All rows of T(i,j): offsets, uint64, shape (largest id + 2,), and entries, uint32.

        The row of id k is entries[offsets[k]:offsets[k + 1]]. Raises as `adjacent` does.
        """
        return self._held.relation(i, j)

    def vertices_of(self, dimension: int, id: int) -> np.ndarray:
        """Vertices of an entity in the order of its template: uint32."""
        return self._held.vertices_of(dimension, id)

    def find(self, dimension: int, vertices: Sequence[int]) -> int | None:
        """The edge, face or region on just these vertices, in any order; None: there is none."""
        return self._held.find(dimension, list(vertices))

    def users(self, dimension: int, id: int) -> list[tuple[int, int]]:
        """The higher entities that use an entity, as (dimension, id)."""
        return self._held.users(dimension, id)

    def classification(self, dimension: int, id: int) -> tuple[int, int] | None:
        """The model entity that an entity lies on, as (dimension, tag); None: nothing."""
        return self._held.classification(dimension, id)

    def memory(self) -> tuple[int, int]:
        """Bytes of the entities and of the adjacencies."""
        return self._held.memory()

    def verify(self, *, unused: bool = False) -> list[tuple[str, tuple[int, int], str]]:
        """What is inconsistent: name, entity and a sentence each. Empty for a sound database."""
        return self._held.verify(unused)

    def classify(self, *, angle: float | None = 20, replace: bool = False) -> dict:
        """Says what each entity lies on, as `aomd.classify` does. Makes all edges."""
        return self._held.classify(angle, replace)

    def create_vertex(self, position: Sequence[float], model: tuple[int, int] | None = None) -> int:
        """A new vertex, on a model entity (dimension, tag). Returns its id."""
        return self._held.create_vertex(position, model)

    def create(self, dimension: int, vertices: Sequence[int],
               model: tuple[int, int] | None = None) -> int:
        """A new edge, face or region on these vertices, with its sides. Returns its id.

        Raises ValueError where they form none, or where there is one already.
        """
        return self._held.create(dimension, list(vertices), model)

    def destroy(self, dimension: int, id: int, *, with_users: bool = False) -> None:
        """Deletes an entity. Raises RuntimeError, naming its users, unless these go along."""
        self._held.destroy(dimension, id, with_users)

    def move(self, vertex: int, position: Sequence[float]) -> None:
        """Moves a vertex to x, y, z."""
        self._held.move(vertex, position)

    def set_classification(self, dimension: int, id: int, model: tuple[int, int] | None) -> None:
        """Puts an entity on a model entity (dimension, tag).

        Raises ValueError for one of lower dimension than the entity.
        """
        self._held.set_classification(dimension, id, model)

    def record(self) -> None:
        """From now on every edit is a step of the history."""
        self._held.record()

    @property
    def steps(self) -> int:
        """How many steps the history has. Raises RuntimeError where nothing is recorded."""
        return self._held.steps()

    @property
    def cursor(self) -> int:
        """How many of them are applied."""
        return self._held.cursor()

    def step(self, index: int) -> tuple[str, tuple[int, int] | None]:
        """What a step was: its kind ("collapse", "swap", ...), and the entity that it was about.

        None for the entity of a single edit. Raises IndexError for a step that there is not.
        """
        return self._held.step(index)

    def undo(self) -> bool:
        """Takes the last step back; False where there is none. Ids and bits are as before."""
        return self._held.undo()

    def redo(self) -> bool:
        """Does the next step again; False where there is none."""
        return self._held.redo()

    def seek(self, step: int) -> None:
        """Undoes or redoes until so many steps are applied."""
        self._held.seek(step)


class Decimation:
    """Decimates a Database step by step, and says why an edge stays."""

    def __init__(self, database: Database, **options):
        """With the options of `decimate` that say how (see `decimate_options`).

        The database must be classified. Raises ValueError where it cannot be decimated, and as
        `decimate` does.
        """
        words, keep, spacing = _told("Decimation", dict(options))
        self._stepping = _aomd.Decimation(database._held, words, keep, spacing)

    def step(self) -> tuple[str, tuple[int, int]] | None:
        """One operation: its kind, and the entity that it was about; None when all is done."""
        return self._stepping.step()

    def sweep(self) -> int:
        """To the end of the present sweep of collapses. Returns how many there were."""
        return self._stepping.sweep()

    def swap(self) -> int:
        """One pass of swaps. Returns how many there were."""
        return self._stepping.swap()

    def smooth(self) -> int:
        """One pass of smoothing. Returns how many vertices moved."""
        return self._stepping.smooth()

    def run(self, *, progress: Progress | None = None, seconds: float | None = None) -> bool:
        """Until all is done, or for about so many seconds. Returns whether all is done.

        progress is called, and may end it, as in `decimate`; what was done until then stays.
        """
        return self._stepping.run(progress, seconds)

    @property
    def done(self) -> bool:
        """Whether nothing more goes."""
        return self._stepping.done()

    @property
    def phase(self) -> str:
        """What comes next: "collapse", "swap", "smooth" or "done"."""
        return self._stepping.phase()

    @property
    def progress(self) -> float:
        """A guess in [0, 1]."""
        return self._stepping.progress()

    def judge(self, edge: int) -> dict:
        """What the run would say of an edge now.

        "accepted"; "reason", a word, or None; "number", the angle in degrees or the length that
        decided; "entity" that decided, as (dimension, id), or None; "deleted", the vertex that
        would go, or None.
        """
        return self._stepping.judge(edge)

    def why(self, edge: int) -> list[str]:
        """The same in sentences, one for each way to collapse the edge."""
        return self._stepping.why(edge)

    def why_swap(self, edge: int) -> str | None:
        """What swapping an edge would come to; None while the quality strategy collapses."""
        return self._stepping.why_swap(edge)

    def why_move(self, vertex: int) -> str | None:
        """What smoothing a vertex would come to; None while the quality strategy collapses."""
        return self._stepping.why_move(vertex)

    def edges_left(self) -> dict[str, int]:
        """How many edges each reason keeps, most first."""
        return self._stepping.edges_left()

    def why_stopped(self) -> str:
        """The same in a sentence."""
        return self._stepping.why_stopped()

    @property
    def sweeps(self) -> list[dict]:
        """What each sweep did and refused: "sweeps" of a report."""
        return json.loads(self._stepping.sweeps())
