#!/usr/bin/env python3
"""Writes a scene of very many small things: what costs time and memory then is all that is kept beside the triangles.

    many_nodes_scene.py --output=FILE.glb [--nodes=100000] [--draws=10000] [--seed=1]

Each draw is a mesh of one primitive: a bent strip of 4 triangles that share no vertices in the file, so that welding
finds something. Nodes place the meshes in turn, ten levels deep. The same options give the same bytes everywhere.
"""

import argparse
import json
import random
import struct

TRIANGLES = 4


def strip(rng):
    """Positions (x, y, z) and indices of a strip, in which every triangle has corners of its own."""
    points = [(i / 2, float(i % 2), rng.randrange(-8, 9) / 16) for i in range(TRIANGLES + 2)]
    triangles = list(range(TRIANGLES))
    rng.shuffle(triangles)
    corners = [points[t + c] for t in triangles for c in ((0, 1, 2) if t % 2 == 0 else (1, 0, 2))]
    return corners, list(range(len(corners)))


def scene(nodes, draws, seed):
    rng = random.Random(seed)
    binary = bytearray()
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(0, nodes, 10))}],
                "nodes": [], "meshes": [], "materials": [{"name": "grey"}], "accessors": [], "bufferViews": []}
    views = document["bufferViews"]
    positions, indices = bytearray(), bytearray()
    for draw in range(draws):
        corners, order = strip(rng)
        lows = [min(c[i] for c in corners) for i in range(3)]
        highs = [max(c[i] for c in corners) for i in range(3)]
        document["accessors"] += [
            {"bufferView": 0, "byteOffset": len(positions), "componentType": 5126, "count": len(corners),
             "type": "VEC3", "min": lows, "max": highs},
            {"bufferView": 1, "byteOffset": len(indices), "componentType": 5123, "count": len(order),
             "type": "SCALAR"}]
        positions += b"".join(struct.pack("<3f", *c) for c in corners)
        indices += struct.pack(f"<{len(order)}H", *order)
        document["meshes"].append({"name": f"strip {draw}", "primitives": [
            {"attributes": {"POSITION": 2 * draw}, "indices": 2 * draw + 1, "material": 0}]})
    for target, stride, part in ((34962, 12, positions), (34963, None, indices)):
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(part), "target": target})
        if stride:
            views[-1]["byteStride"] = stride
        binary += part
    document["buffers"] = [{"byteLength": len(binary)}]
    for n in range(nodes):
        node = {"mesh": n % draws, "translation": [rng.randrange(-4096, 4096) / 8 for _ in range(3)]}
        if n % 10 != 9 and n + 1 < nodes:
            node["children"] = [n + 1]
        document["nodes"].append(node)
    return document, bytes(binary)


def glb(document, binary):
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    header = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary))
    return header + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", required=True)
    parser.add_argument("--nodes", type=int, default=100_000)
    parser.add_argument("--draws", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    with open(options.output, "wb") as file:
        file.write(glb(*scene(options.nodes, options.draws, options.seed)))


if __name__ == "__main__":
    main()
