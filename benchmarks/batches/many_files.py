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
import os
import random
import shutil
import struct
import subprocess
import time
from pathlib import Path
from statistics import median

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


def cold(program, folder, options):
    """Without a cache, and filling one, by turns. The folders are new ones each time: who has just removed thousands of
    files makes the file system look long for places of new ones."""
    plain, filling = [], []
    for i in range(options.rounds):
        turns = [(plain, ["-o", str(folder / f"plain{i}")]),
                 (filling, ["-o", str(folder / f"out{i}"), "--cache", str(folder / f"cache{i}")])]
        for seconds, more in turns if i % 2 == 0 else reversed(turns):
            seconds.append(run([program, "optimize", str(folder / "in"), "--threads", "1"] + more + PIPELINE)[1])
    ratio = median(b / a for a, b in zip(plain, filling))
    print(f"| without a cache, one thread | {median(plain):.2f} s of a processor |")
    print(f"| the same, filling a cache | {median(filling):.2f} s: {100 * (ratio - 1):+.1f} % |", flush=True)


def again(program, folder, options):
    """What was done is not done again."""
    out, cache, report = folder / "out0", folder / "cache0", folder / "second.json"
    before = facts(out)
    second = [program, "optimize", str(folder / "in"), "-o", str(out), "--cache", str(cache), "--report", str(report)]
    runs = [run(second + PIPELINE) for _ in range(options.rounds)]
    clock, processors, memory = median(r[0] for r in runs), median(r[1] for r in runs), max(r[2] for r in runs)
    cached = sum(file.get("cached", False) for file in json.loads(report.read_text())["files"])
    after = facts(out)
    touched = sum(after[path] != was for path, was in before.items())
    different = [p for p in before if p.read_bytes() != (folder / "plain0" / p.relative_to(out)).read_bytes()]
    assert not different, different[:3]
    print(f"| again | {processors:.2f} s of processors, {1000 * processors / options.files:.2f} ms a file "
          f"({clock:.2f} s on the clock), {memory:.0f} MB at most |")
    print(f"| of these from the cache | {cached:,} |")
    print(f"| outputs touched | {touched} |", flush=True)


def parts(program, folder, options):
    """One process of one thread, and 16 shards of one thread each, two at a time, by turns."""
    whole, shared = [], []
    for i in range(options.rounds):
        target = folder / f"one{i}"
        whole.append(run([program, "optimize", str(folder / "in"), "-o", str(target), "--threads", "1", "--report",
                          f"{target}.json"] + PIPELINE))
        shared.append(shards(program, str(folder / "in"), str(folder / f"parts{i}"), 16, 2))
    clock = median(a[0] / b[0] for a, b in zip(whole, shared))
    processors = median(b[1] / a[1] for a, b in zip(whole, shared))
    print(f"| one process of one thread | {median(w[1] for w in whole):.2f} s of processors "
          f"({median(w[0] for w in whole):.2f} s on the clock) |")
    print(f"| 16 shards, two at a time | {processors:.3f} times of processors, 1/{clock:.2f} on the clock |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--files", type=int, default=10000)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--folder", default="build/batches")
    options = parser.parse_args()
    folder = Path(options.folder)
    shutil.rmtree(folder, ignore_errors=True)
    make_files(folder / "in", options.files)
    time.sleep(10)  # until the file system has forgotten what was removed
    print(f"| {options.files:,} files | |\n|---|---|", flush=True)
    for measure in (cold, again, parts):
        measure(options.program, folder, options)


if __name__ == "__main__":
    main()
