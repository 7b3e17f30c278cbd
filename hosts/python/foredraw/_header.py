"""The C headers as ctypes sees them: status.h, draw.h, functions.h and its parts, plugin.h, module.h, foredraw.h. A test holds this to what a compiler says."""

from ctypes import CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_float, c_int, c_int64, c_uint32, c_uint64, c_void_p

# Statuses.
DONE, MISTAKE, FAILED, CANCELLED, NO_MEMORY, NULL_POINTER = range(6)
INDEX_COUNT, INDEX_BYTES, INDEX_RANGE, TOO_LARGE, OPTION_RANGE, NO_CLUSTERS, NO_ORDER, NO_TRANSFORM = range(6, 14)

LOOKAHEAD_FAST, LOOKAHEAD_BALANCED, LOOKAHEAD_HIGH = range(1, 4)
LOOKAHEAD_ROBUST, LOOKAHEAD_FIFO, LOOKAHEAD_NVIDIA, LOOKAHEAD_AMD, LOOKAHEAD_INTEL = range(1, 6)

OCCLUSION_FAST, OCCLUSION_BALANCED, OCCLUSION_HIGH = range(1, 4)
SHELL_CLOSED, SHELL_OPEN, SHELL_FLAT, SHELL_INSIDE_OUT, SHELL_TURNED = range(5)
DIRECTION, BLENDED = 0x100, 0x200
WRAP_REPEAT, WRAP_MIRRORED, WRAP_CLAMPED = range(3)
UV_FLOAT32, UV_FLOAT16, UV_UNORM16 = range(3)
TRIMMED, RECTANGLE, EMPTY, FULL, NO_SAVING = range(5)

# What a component of a stream is.
INT8, UINT8, INT16, UINT16, UINT32, FLOAT32 = range(1, 7)


class Triangles(Structure):
    _fields_ = [
        ("indices", c_void_p),
        ("index_count", c_uint64),
        ("index_bytes", c_uint32),
        ("vertex_count", c_uint32),
    ]


class Positions(Structure):
    _fields_ = [("first", c_void_p), ("stride", c_uint32)]


class Attribute(Structure):
    _fields_ = [("first", c_void_p), ("stride", c_uint32), ("bytes", c_uint32)]


class Collapse(Structure):
    _fields_ = [("removed", c_uint32), ("kept", c_uint32), ("blend", c_float), ("error", c_float)]


class VertexPair(Structure):
    _fields_ = [("removed", c_uint32), ("kept", c_uint32)]


class Collapses(Structure):
    _fields_ = [
        ("collapses", c_void_p),
        ("pairs", c_void_p),
        ("first_pair", c_void_p),
        ("places", c_void_p),
        ("count", c_uint32),
        ("solves", c_uint32),
    ]


class WeightedAttribute(Structure):
    _fields_ = [("first", c_void_p), ("stride", c_uint32), ("components", c_uint32), ("weight", c_double)]


class Simplified(Structure):
    _fields_ = [("index_count", c_uint64), ("collapses", c_uint32), ("reserved", c_uint32), ("error", c_double)]


class Alpha(Structure):
    _fields_ = [
        ("first", c_void_p),
        ("width", c_uint32),
        ("height", c_uint32),
        ("bytes", c_uint32),
        ("texel_stride", c_uint32),
        ("row_stride", c_uint64),
    ]


class Rectangle(Structure):
    _fields_ = [("x", c_uint32), ("y", c_uint32), ("width", c_uint32), ("height", c_uint32)]


class TrimOptions(Structure):
    _fields_ = [
        ("size", c_uint32),
        ("vertices", c_uint32),
        ("threshold", c_double),
        ("padding", c_double),
        ("least_saving", c_double),
        ("mip_levels", c_uint32),
        ("wrap_u", c_uint32),
        ("wrap_v", c_uint32),
        ("is_nearest", c_uint32),
        ("uv", c_uint32),
        ("reserved", c_uint32),
    ]


class Trimmed(Structure):
    _fields_ = [
        ("outcome", c_uint32),
        ("corner_count", c_uint32),
        ("area", c_double),
        ("frame_area", c_double),
        ("lost", c_double),
    ]


class PackedMesh(Structure):
    _fields_ = [
        ("triangles", Triangles),
        ("positions", Positions),
        ("first_vertex", c_uint32),
        ("reserved", c_uint32),
    ]


class PlacedMesh(Structure):
    _fields_ = [("mesh", c_uint32), ("transform", c_float * 12)]


class MergedSlot(Structure):
    _fields_ = [("index_offset", c_uint32), ("instance", c_uint32)]


class MergedDraw(Structure):
    _fields_ = [("group", c_uint32), ("frequency", c_uint32), ("first_slot", c_uint32), ("slot_count", c_uint32)]


class MergedGroup(Structure):
    _fields_ = [
        ("least", c_float * 3),
        ("most", c_float * 3),
        ("first_instance", c_uint32),
        ("instance_count", c_uint32),
    ]


class Merged(Structure):
    _fields_ = [
        ("indices", c_void_p),
        ("slots", c_void_p),
        ("transforms", c_void_p),
        ("placed", c_void_p),
        ("draws", c_void_p),
        ("groups", c_void_p),
        ("index_count", c_uint64),
        ("slot_count", c_uint64),
        ("instance_count", c_uint32),
        ("draw_count", c_uint32),
        ("group_count", c_uint32),
        ("reserved", c_uint32),
        ("owner", c_void_p),
    ]


class OverdrawFigures(Structure):
    _fields_ = [
        ("shaded", c_uint64),
        ("visible", c_uint64),
        ("ties", c_uint64),
        ("ratio", c_double),
        ("error", c_double),
        ("worst_view", c_double),
    ]


class SurfaceErrorFigures(Structure):
    _fields_ = [
        ("largest", c_double),
        ("found", c_double),
        ("rms", c_double),
        ("rms_error", c_double),
        ("mean", c_double),
        ("mean_error", c_double),
        ("p99", c_double),
        ("p99_error", c_double),
    ]


class VertexCacheFigures(Structure):
    _fields_ = [("misses", c_uint64), ("vertices", c_uint64), ("acmr", c_double), ("atvr", c_double)]


class Text(Structure):
    _fields_ = [("data", c_void_p), ("length", c_uint64)]


Progress = CFUNCTYPE(c_int, c_void_p, c_char_p, c_double)


class Settings(Structure):
    _fields_ = [("size", c_uint32), ("threads", c_uint32), ("progress", Progress), ("user", c_void_p)]


class Stream(Structure):
    _fields_ = [
        ("semantic", c_char_p),
        ("bytes", c_void_p),
        ("stride", c_uint32),
        ("component", c_uint32),
        ("components", c_uint32),
        ("normalized", c_uint32),
    ]


class Draw(Structure):
    _fields_ = [
        ("size", c_uint32),
        ("vertex_count", c_uint32),
        ("triangle_count", c_uint64),
        ("name", c_char_p),
        ("indices", c_void_p),
        ("positions", c_void_p),
        ("stream_count", c_uint32),
        ("streams", POINTER(Stream)),
        ("cluster_count", c_uint32),
        ("cluster_offsets", c_void_p),
    ]


# What a technique is, and what its options are of.
TRIANGLE_ORDERER, VERTEX_ORDERER, CLUSTERER, EVALUATOR, REMESHER = range(1, 6)
LOSSLESS, USES_OVERDRAW = 1, 2
BOOLEAN, INTEGER, NUMBER, TEXT, CHOICE = range(1, 6)


class Value(Structure):
    _fields_ = [("integer", c_int64), ("number", c_double), ("text", c_char_p)]


class Option(Structure):
    _fields_ = [
        ("name", c_char_p),
        ("doc", c_char_p),
        ("unit", c_char_p),
        ("type", c_uint32),
        ("choice_count", c_uint32),
        ("choices", POINTER(c_char_p)),
        ("initial", Value),
        ("least", c_double),
        ("most", c_double),
    ]


class Metric(Structure):
    _fields_ = [("name", c_char_p), ("unit", c_char_p), ("doc", c_char_p), ("higher_is_better", c_uint32)]


class Answer(Structure):
    _fields_ = [
        ("values", POINTER(c_uint32)),
        ("count", c_uint64),
        ("vertex_from", POINTER(c_uint32)),
        ("vertex_count", c_uint64),
    ]


class Host(Structure):
    _fields_ = [
        ("size", c_uint32),
        ("reserved", c_uint32),
        ("seed", c_uint64),
        ("self", c_void_p),
        ("cancelled", CFUNCTYPE(c_int, c_void_p)),
        ("keep", CFUNCTYPE(None, c_void_p, c_char_p)),
        ("fail", CFUNCTYPE(None, c_void_p, c_char_p)),
        ("note", CFUNCTYPE(None, c_void_p, c_char_p, c_char_p)),
        ("count", CFUNCTYPE(None, c_void_p, c_char_p, c_double)),
        ("measure", CFUNCTYPE(None, c_void_p, c_char_p, c_double, c_double, c_double)),
        ("count_overdraw", CFUNCTYPE(c_int, c_void_p, POINTER(c_uint32), POINTER(c_uint64), POINTER(c_uint64))),
    ]


Run = CFUNCTYPE(c_int, c_void_p, POINTER(Draw), POINTER(Value), POINTER(Answer), POINTER(Host))


class Plugin(Structure):
    _fields_ = [
        ("size", c_uint32),
        ("kind", c_uint32),
        ("name", c_char_p),
        ("summary", c_char_p),
        ("reference", c_char_p),
        ("needs", c_char_p),
        ("provides", c_char_p),
        ("breaks", c_char_p),
        ("options", POINTER(Option)),
        ("metrics", POINTER(Metric)),
        ("option_count", c_uint32),
        ("metric_count", c_uint32),
        ("runs_on_many_threads", c_uint32),
        ("user", c_void_p),
        ("run", Run),
        ("acts_on", c_char_p),
        ("pays_if", c_char_p),
        ("flags", c_uint32),
        ("reserved", c_uint32),
    ]


class Module(Structure):
    _fields_ = [
        ("size", c_uint32),
        ("major", c_uint32),
        ("minor", c_uint32),
        ("plugin_count", c_uint32),
        ("vendor", c_char_p),
        ("version", c_char_p),
        ("plugins", POINTER(POINTER(Plugin))),
    ]


# The version of modules.
MODULE_MAJOR, MODULE_MINOR = 1, 1

_places = POINTER(Positions)
_triangles, _text, _pointer = POINTER(Triangles), POINTER(Text), POINTER(c_void_p)

#: By the name without its "foredraw_": what the function returns, and what it takes. Arrays and handles are addresses.
PROTOTYPES = {
    "status_text": (c_char_p, [c_int]),
    "tipsify": (c_int, [c_void_p, _triangles, c_uint32]),
    "forsyth": (c_int, [c_void_p, _triangles, c_uint32]),
    "lookahead": (c_int, [c_void_p, _triangles, c_int, c_int, c_uint32]),
    "linear_clusters": (c_int, [c_void_p, POINTER(c_uint32), _triangles, c_uint32, c_double]),
    "dot_rule": (c_int, [c_void_p, _triangles, _places, c_void_p, c_uint32]),
    "order_of_clusters": (c_int, [c_void_p, c_void_p, c_uint32, c_void_p]),
    "vertex_fetch": (c_int, [c_void_p, POINTER(c_uint32), _triangles]),
    "reorder_triangles": (c_int, [c_void_p, _triangles, c_void_p]),
    "renumber_vertices": (c_int, [c_void_p, _triangles, c_void_p]),
    "reorder_elements": (c_int, [c_void_p, c_void_p, c_uint64, c_uint32, c_void_p, c_uint64]),
    "move_vertices": (c_int, [c_void_p, _triangles, c_void_p]),
    "weld": (c_int, [c_void_p, c_void_p, POINTER(c_uint32), _triangles, POINTER(Attribute), c_uint32, c_int]),
    "occlusion_order": (c_int, [c_void_p, _triangles, _places, c_int, c_double, c_uint32, c_int]),
    "quadric_collapse": (
        c_int,
        [POINTER(Collapses), _triangles, _places, POINTER(WeightedAttribute), c_uint32, c_uint32],
    ),
    "shell_kinds": (c_int, [c_void_p, _triangles, _places]),
    "simplify": (
        c_int,
        [c_void_p, c_void_p, POINTER(Simplified), _triangles, _places, POINTER(Collapses), c_uint32, c_double],
    ),
    "level_attributes": (
        c_int,
        [c_void_p, _triangles, _places, POINTER(Collapses), c_uint32, POINTER(WeightedAttribute), c_uint32],
    ),
    "sprite_frames": (c_int, [c_void_p, POINTER(c_uint32), POINTER(Alpha), c_double, c_uint32]),
    "particle_trim": (c_int, [c_void_p, c_void_p, POINTER(Alpha), c_void_p, c_uint32, POINTER(TrimOptions)]),
    "merge_instances": (
        c_int,
        [POINTER(Merged), POINTER(PackedMesh), c_uint32, POINTER(PlacedMesh), c_uint32, c_uint32, c_double],
    ),
    "merged_free": (None, [POINTER(Merged)]),
    "overdraw": (c_int, [POINTER(OverdrawFigures), _triangles, _places, c_uint32, c_uint32, c_int]),
    "surface_error": (
        c_int,
        [POINTER(SurfaceErrorFigures), _triangles, _places, _triangles, _places, c_uint32, c_uint64],
    ),
    "vertex_cache": (c_int, [POINTER(VertexCacheFigures), _triangles, c_uint32]),
    "version": (c_uint32, []),
    "text_free": (None, [_text]),
    "context_new": (c_void_p, [POINTER(Settings)]),
    "context_free": (None, [c_void_p]),
    "add_plugin": (c_int, [c_void_p, POINTER(Plugin), _text]),
    "load_module": (c_int, [c_void_p, c_char_p, c_uint32, _text]),
    "serve_module": (c_int, [POINTER(Module)]),
    "cancel": (None, [c_void_p]),
    "read": (c_int, [c_void_p, c_char_p, _pointer, _text]),
    "read_memory": (c_int, [c_void_p, c_void_p, c_uint64, c_char_p, _pointer, _text]),
    "write": (c_int, [c_void_p, c_void_p, c_char_p, _text]),
    "write_as": (c_int, [c_void_p, c_void_p, c_char_p, c_char_p, _text]),
    "write_memory": (c_int, [c_void_p, c_void_p, c_char_p, c_char_p, _text, _text]),
    "make_scene": (c_int, [c_void_p, POINTER(Draw), c_uint64, _pointer, _text]),
    "scene_draws": (c_uint64, [c_void_p]),
    "scene_draw": (c_int, [c_void_p, c_uint64, POINTER(Draw)]),
    "scene_moves": (c_int, [c_void_p, c_uint64, _pointer, _pointer, POINTER(c_uint64)]),
    "scene_copy": (c_void_p, [c_void_p]),
    "scene_free": (None, [c_void_p]),
    "order": (c_int, [c_void_p, c_char_p, _triangles, _places, c_void_p, _text]),
    "cluster": (
        c_int,
        [c_void_p, c_char_p, _triangles, _places, c_void_p, c_void_p, POINTER(c_uint32), _text],
    ),
    "optimize": (c_int, [c_void_p, c_void_p, c_char_p, _pointer, _text]),
    "measure": (c_int, [c_void_p, c_void_p, c_char_p, _text]),
    "compare": (c_int, [c_void_p, _pointer, c_uint64, POINTER(c_char_p), c_uint64, c_uint32, _text]),
}
