#!/usr/bin/python3
"""What a cache and shards cost and save over many small files.

    benchmarks/batches/many_files.py build/release/hosts/cli/foredraw [--files 10000] [--folder build/batches]

Makes so many small scenes (.glb and .gltf with a .bin each, by a seed), then measures: a run without a cache and one that
fills it, in turn, so that other work on the machine meets both; a second run, of which no stage may run and no output may be
touched; and 16 shards of one thread each, two at a time, against one process of one thread. Prints a table. Seconds of
processors count what the work costs however busy the machine is: where 16 shards take no more than 1.05 times those of one
process, two at a time take 1/1.9 of its time on two processors that nobody else uses.
"""

import argparse
import json
import math
import os
import random
import shutil
import struct
import subprocess
import time
from pathlib import Path

PIPELINE = ["-p", "weld, lookahead, vertex-fetch", "--with", "vertex-cache"]


def bumpy_sheet(cells, rng):
    """Indices in a random sequence, and positions, of a sheet of so many cells along each side."""
    side = cells + 1
    positions = [(x / cells, y / cells, 0.1 * rng.random()) for y in range(side) for x in range(side)]
    triangles = []
    for y in range(cells):
        for x in range(cells):
            a = y * side + x
            triangles += [(a, a + 1, a + side), (a + side, a + 1, a + side + 1)]
    rng.shuffle(triangles)
    return triangles, positions


def scene(cells, rng, uri):
    """The JSON and the bytes of one draw."""
    triangles, positions = bumpy_sheet(cells, rng)
    indices = b"".join(struct.pack("<3H", *t) for t in triangles)
    indices += b"\0" * (-len(indices) % 4)
    data = indices + b"".join(struct.pack("<3f", *p) for p in positions)
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}]}],
        "buffers": [{"byteLength": len(data)} | ({"uri": uri} if uri else {})],
        "bufferViews": [
            {"buffer": 0, "byteLength": len(indices), "target": 34963},
            {"buffer": 0, "byteOffset": len(indices), "byteLength": len(data) - len(indices), "target": 34962},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5123, "count": 3 * len(triangles), "type": "SCALAR"},
            {"bufferView": 1, "componentType": 5126, "count": len(positions), "type": "VEC3",
             "min": [min(p[i] for p in positions) for i in range(3)],
             "max": [max(p[i] for p in positions) for i in range(3)]},
        ],
    }
    return document, data


def make_files(folder, count):
    for i in range(count):
        rng = random.Random(i)
        place = folder / f"set{i % 40:02}"
        place.mkdir(parents=True, exist_ok=True)
        name = f"prop{i:06}"
        cells = rng.randint(6, 20)
        if i % 4 == 0:
            document, data = scene(cells, rng, f"{name}.bin")
            (place / f"{name}.bin").write_bytes(data)
            (place / f"{name}.gltf").write_text(json.dumps(document))
        else:
            document, data = scene(cells, rng, None)
            text = json.dumps(document).encode()
            text += b" " * (-len(text) % 4)
            size = 12 + 8 + len(text) + 8 + len(data)
            (place / f"{name}.glb").write_bytes(struct.pack("<4sII", b"glTF", 2, size) +
                                                struct.pack("<I4s", len(text), b"JSON") + text +
                                                struct.pack("<I4s", len(data), b"BIN\0") + data)


def run(arguments):
    """Seconds on the clock, seconds of processors, and the peak of memory in MB, of one process."""
    begin = time.monotonic()
    child = subprocess.Popen(arguments, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    assert child.returncode == 0, arguments
    return time.monotonic() - begin, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def facts(folder):
    return {p: (p.stat().st_ino, p.stat().st_mtime_ns) for p in folder.rglob("*") if p.is_file()}


def shards(program, source, target, count, at_once):
    """Seconds on the clock for all of them, so many at once, and seconds of processors."""
    begin, processors = time.monotonic(), 0
    waiting = list(range(1, count + 1))
    running = {}
    while waiting or running:
        while waiting and len(running) < at_once:
            number = waiting.pop(0)
            child = subprocess.Popen([program, "optimize", source, "-o", target, "--threads", "1", "--shard",
                                      f"{number}/{count}", "--report", f"{target}-{number}.json"] + PIPELINE,
                                     stderr=subprocess.DEVNULL)
            running[child.pid] = child
        pid, status, usage = os.wait4(-1, 0)
        child = running.pop(pid)
        child.returncode = os.waitstatus_to_exitcode(status)
        assert child.returncode == 0, pid
        processors += usage.ru_utime + usage.ru_stime
    return time.monotonic() - begin, processors


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--files", type=int, default=10000)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--folder", default="build/batches")
    options = parser.parse_args()
    program, folder = options.program, Path(options.folder)
    shutil.rmtree(folder, ignore_errors=True)
    source = folder / "in"
    make_files(source, options.files)
    command = [program, "optimize", str(source), "-o"]

    plain, filling = math.inf, math.inf
    for _ in range(options.rounds):
        for name in ("plain", "out", "cache"):
            shutil.rmtree(folder / name, ignore_errors=True)
        plain = min(plain, run(command + [str(folder / "plain"), "--threads", "1"] + PIPELINE)[1])
        filling = min(filling, run(command + [str(folder / "out"), "--threads", "1", "--cache", str(folder / "cache")] +
                                   PIPELINE)[1])
    before = facts(folder / "out")
    report = folder / "second.json"
    second = command + [str(folder / "out"), "--cache", str(folder / "cache"), "--report", str(report)] + PIPELINE
    seconds = [run(second) for _ in range(options.rounds)]
    clock, processors, memory = min(s[0] for s in seconds), min(s[1] for s in seconds), max(s[2] for s in seconds)
    cached = sum(file.get("cached", False) for file in json.loads(report.read_text())["files"])
    touched = sum(facts(folder / "out")[path] != was for path, was in before.items())
    different = [p for p in before if p.read_bytes() != (folder / "plain" / p.relative_to(folder / "out")).read_bytes()]
    assert not different, different[:3]

    one, parts = (math.inf, math.inf), (math.inf, math.inf)
    for _ in range(options.rounds):
        for name in ("one", "parts"):
            shutil.rmtree(folder / name, ignore_errors=True)
        whole = run(command + [str(folder / "one"), "--threads", "1", "--report", str(folder / "one.json")] + PIPELINE)
        one = tuple(map(min, one, whole[:2]))
        parts = tuple(map(min, parts, shards(program, str(source), str(folder / "parts"), 16, 2)))

    print(f"| {options.files:,} files | |\n|---|---|")
    print(f"| without a cache, one thread | {plain:.2f} s of a processor |")
    print(f"| the same, filling a cache | {filling:.2f} s: {100 * (filling / plain - 1):+.1f} % |")
    print(f"| again | {processors:.2f} s of processors, {1000 * processors / options.files:.2f} ms a file "
          f"({clock:.2f} s on the clock), {memory:.0f} MB at most |")
    print(f"| of these from the cache | {cached:,} |")
    print(f"| outputs touched | {touched} |")
    print(f"| one process of one thread | {one[1]:.2f} s of processors ({one[0]:.2f} s on the clock) |")
    print(f"| 16 shards, two at a time | {parts[1]:.2f} s of processors: {parts[1] / one[1]:.3f} times "
          f"({parts[0]:.2f} s on the clock: 1/{one[0] / parts[0]:.2f}) |")


if __name__ == "__main__":
    main()
