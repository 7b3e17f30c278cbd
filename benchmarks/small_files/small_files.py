#!/usr/bin/python3
"""Bytes of compressed files at the same errors, beside gltfpack.

    benchmarks/small_files/small_files.py build/release/hosts/cli/foredraw GLTFPACK [MODEL...]

GLTFPACK is the program of the newest meshoptimizer, built by its own CMakeLists.txt. Each model (default: the corpus) goes
through it with -cc, and through the stages of @small with --compression, both for
EXT_meshopt_compression, then both for KHR_meshopt_compression (-cz -ce khr). gltfpack has its default bits: 14 for
positions, in a grid over the box of all meshes; 12 for texture coordinates; 8 for normals. `quantize` is asked for the error
that such a grid has in the middle of a cell, and for the angle that 8 bits have. gltfpack keeps what materials do not use
(-kv), names and materials (-kn -km), as Foredraw is asked to.

Prints the bytes of all buffer views of vertices and indices, ours over gltfpack's, and the geometric mean; with --markdown
the table of docs/results/small-files.md.
"""

import argparse
import json
import math
import struct
import subprocess
import tempfile
from pathlib import Path

PIPELINE = """pipeline = 1
stages = [
  "prune(attributes=false, tracks=false)",
  "quantize(position-error={error}, uv-error={uv_error}, direction-error=0.86)",
  "weld", "codec-order", "vertex-fetch(always=true)", "skin-slots",
]
measure = ["vertex-cache"]
[subjects]
subject = "scene"
"""


def document(path):
    return parts(path)[0]


def parts(path):
    """The JSON and the bytes of a .glb."""
    data = Path(path).read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + length]), data[28 + length:]


def coded_bytes(path):
    """Bytes of the views of vertices and of indices, and of the whole file."""
    json_of = document(path)
    accessors = json_of.get("accessors", [])
    kinds = {}
    for mesh in json_of.get("meshes", []):
        for primitive in mesh["primitives"]:
            if "indices" in primitive:
                kinds[primitive["indices"]] = "indices"
            for names in [primitive["attributes"], *primitive.get("targets", [])]:
                kinds.update(dict.fromkeys(names.values(), "vertices"))
    of_view = {accessors[a]["bufferView"]: kind for a, kind in kinds.items() if "bufferView" in accessors[a]}
    result = {"vertices": 0, "indices": 0, "file": Path(path).stat().st_size}
    for number, view in enumerate(json_of.get("bufferViews", [])):
        coded = next((e for name, e in view.get("extensions", {}).items() if "meshopt" in name), view)
        if number in of_view:
            result[of_view[number]] += coded["byteLength"]
    return result


def position_error(path):
    """What the middle of a cell of gltfpack's grid is off, as part of the diagonal of the largest draw."""
    json_of = document(path)
    primitives = [p for mesh in json_of["meshes"] for p in mesh["primitives"]]
    boxes = [json_of["accessors"][p["attributes"]["POSITION"]] for p in primitives]
    diagonal = max(math.dist(box["min"], box["max"]) for box in boxes)
    extent = max(max(box["max"][k] for box in boxes) - min(box["min"][k] for box in boxes) for k in range(3))
    return math.sqrt(3) / 2 * extent / 16383 / diagonal


def uv_error(path):
    """What the middle of a cell of gltfpack's grid over all texture coordinates is off, in texels of 4096."""
    json_of, data = parts(path)
    names = {n for m in json_of["meshes"] for p in m["primitives"] for k, n in p["attributes"].items() if "TEXCOORD" in k}
    extent = 1.0
    for accessor in (json_of["accessors"][n] for n in names):
        view = json_of["bufferViews"][accessor["bufferView"]]
        first = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        rows = [struct.unpack_from("<2f", data, first + i * view.get("byteStride", 8)) for i in range(accessor["count"])]
        if accessor["componentType"] == 5126:
            extent = max(extent, *(max(c) - min(c) for c in zip(*rows)))
    return math.sqrt(2) / 2 * extent * 4096 / 4095


def sizes(arguments, model, extension, folder):
    theirs, ours, pipeline = folder / "theirs.glb", folder / "ours.glb", folder / "pipeline.toml"
    codec = ["-cc"] if extension == "ext" else ["-cz", "-ce", "khr"]
    subprocess.run([arguments.gltfpack, "-i", model, "-o", theirs, *codec, "-kv", "-kn", "-km"], check=True)
    pipeline.write_text(PIPELINE.format(error=position_error(model), uv_error=uv_error(model)))
    subprocess.run([arguments.foredraw, "optimize", model, "-o", ours, "-p", pipeline, "--compression",
                    extension + "-meshopt", "--corners", "turn"], check=True, capture_output=True)
    return coded_bytes(ours), coded_bytes(theirs)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("foredraw")
    parser.add_argument("gltfpack")
    parser.add_argument("models", nargs="*")
    parser.add_argument("--markdown", action="store_true")
    arguments = parser.parse_args()
    corpus = Path(__file__).resolve().parent.parent / "corpus"
    models = arguments.models or sorted(map(str, corpus.glob("*/*.glb")))
    between = " | " if arguments.markdown else "  "
    logarithms = {"ext": [], "khr": []}
    with tempfile.TemporaryDirectory() as name:
        for model in models:
            cells = [f"`{Path(model).name}`" if arguments.markdown else f"{Path(model).name:36}"]
            for extension in logarithms:
                ours, theirs = sizes(arguments, model, extension, Path(name))
                both = [one["vertices"] + one["indices"] for one in (ours, theirs)]
                logarithms[extension].append(math.log(both[0] / both[1]))
                cells += [f"{both[0]:,}", f"{both[1]:,}", f"{both[0] / both[1]:.3f}"]
            print((between + between.join(cells) + between).strip() if arguments.markdown else between.join(cells))
    for extension, all_of_it in logarithms.items():
        print(f"{extension}: geometric mean {math.exp(sum(all_of_it) / len(all_of_it)):.3f}")


main()
