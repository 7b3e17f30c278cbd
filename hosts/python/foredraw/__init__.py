"""Foredraw: make real-time scenes cheaper to draw, before they are drawn.

>>> import foredraw as fd
>>> order = fd.tipsify(indices)
>>> done = fd.optimize(fd.read("house.glb"), "@default")
>>> done.scene.write("cheaper.glb")
>>> fd.compare(["a.glb", "b.glb"], ["@default", "weld, lookahead"])

The package calls the C library libforedraw, which it looks for at the first call: the file that the environment
variable FOREDRAW_LIBRARY names, then one beside the package or in the same installation, then the system's.
"""

from ._library import library_version
from .comparisons import Comparison, compare
from .contexts import Context
from .errors import Cancelled, Error
from .figures import figures
from .functions import (
    VertexCache,
    dot_rule,
    forsyth,
    linear_clusters,
    lookahead,
    order_of_clusters,
    renumber_vertices,
    reorder_elements,
    reorder_triangles,
    tipsify,
    vertex_cache,
    vertex_fetch,
)
from .given_draws import Draw
from .instances import Merged, merge_instances
from .lent_draws import Moves
from .meshes import (
    Collapses,
    Overdraw,
    Simplified,
    SurfaceError,
    Welded,
    level_attributes,
    move_vertices,
    occlusion_order,
    overdraw,
    quadric_collapse,
    shell_kinds,
    simplify,
    surface_error,
    weld,
)
from .one_draw import Clustered, cluster, order
from .runs import Optimized, measure, optimize
from .scenes import Scene, make, read, read_bytes, write, write_bytes
from .sprites import Trimmed, particle_trim, sprite_frames
from .techniques import (
    HandedDraw,
    Keep,
    Metric,
    Option,
    Technique,
    add,
    boolean,
    choice,
    clusterer,
    evaluator,
    integer,
    number,
    orderer,
    remesher,
    text,
    vertex_orderer,
)

__version__ = "0.1.0"

__all__ = [
    "Cancelled",
    "Clustered",
    "Collapses",
    "Comparison",
    "Context",
    "Draw",
    "Error",
    "HandedDraw",
    "Keep",
    "Merged",
    "Metric",
    "Moves",
    "Optimized",
    "Option",
    "Overdraw",
    "Scene",
    "Simplified",
    "SurfaceError",
    "Technique",
    "Trimmed",
    "VertexCache",
    "Welded",
    "add",
    "boolean",
    "choice",
    "cluster",
    "clusterer",
    "compare",
    "dot_rule",
    "evaluator",
    "figures",
    "forsyth",
    "integer",
    "level_attributes",
    "library_version",
    "linear_clusters",
    "lookahead",
    "make",
    "measure",
    "merge_instances",
    "move_vertices",
    "number",
    "occlusion_order",
    "optimize",
    "order",
    "order_of_clusters",
    "orderer",
    "overdraw",
    "particle_trim",
    "quadric_collapse",
    "read",
    "read_bytes",
    "remesher",
    "renumber_vertices",
    "reorder_elements",
    "reorder_triangles",
    "shell_kinds",
    "simplify",
    "sprite_frames",
    "surface_error",
    "text",
    "tipsify",
    "vertex_cache",
    "vertex_fetch",
    "vertex_orderer",
    "weld",
    "write",
    "write_bytes",
]
