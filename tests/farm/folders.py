"""What the tests of this folder work on, and how they compare it. Arguments of each: the program, and a folder of its own."""

import json
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM, FOLDER = sys.argv[1], Path(sys.argv[2]).resolve()
del sys.argv[1:3]  # the rest is for unittest
QUICK = ["-p", "tipsify, vertex-fetch", "--with", "vertex-cache"]


def make_library():
    """The corpus, and a file that can not be read."""
    shutil.rmtree(FOLDER, ignore_errors=True)
    shutil.copytree(ROOT / "benchmarks/corpus", FOLDER / "library")
    (FOLDER / "library/bad.glb").write_text("no scene")


def contents(folder):
    return {str(path.relative_to(FOLDER / folder)): path.read_bytes()
            for path in (FOLDER / folder).rglob("*") if path.is_file()}


def report(name, folder):
    """Of a run whose outputs went to that folder, as if they had gone to "out"."""
    return json.loads((FOLDER / name).read_text().replace(f'"{folder}/', '"out/'))


def without_times(value):
    """What differs from run to run left out."""
    if isinstance(value, dict):
        return {key: without_times(held) for key, held in value.items()
                if key not in ("seconds", "peak-memory", "cached", "shard")}
    return [without_times(held) for held in value] if isinstance(value, list) else value
