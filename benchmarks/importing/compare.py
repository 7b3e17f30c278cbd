#!/usr/bin/python3
"""Imported FBX files beside two other readers: ufbx evaluates the same poses, and FBX2glTF converts the same files.

    benchmarks/importing/compare.py BUILD UFBX [--fbx2gltf PROGRAM] [--poses N] [--limit E] FILE.fbx...

BUILD is a build folder with benchmarks (imported-poses-bench) and foredraw-import; UFBX a folder with ufbx.h and ufbx.c,
which are compiled with `cc`. Of each file, as it stands and at N frames (9) of each animation, the triangles are compared in
world space: the farthest that a corner of one lies from the nearest corner of the other, over the diagonal of the box.
Areas and volumes are told beside it: they show corners that were exchanged and triangles that were turned round, and differ
a little where polygons that are not flat were cut otherwise. FBX2glTF's output is compared with ufbx's poses in the same
way. Takes without keys, which are no clips in glTF, are passed by. Prints a line for each file, and says how many have the
same triangles within E (0.001).
"""

import argparse
import json
import math
import os
import subprocess
import tempfile
from pathlib import Path


def run(command, seconds=120, **more):
    try:
        return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=seconds, **more)
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(command, 124, "", "not done in time")


def figures(bench, scene, referee):
    made = run([bench, scene, referee])
    if made.returncode != 0:
        return {"failed": made.stderr.strip().splitlines()[0] if made.stderr.strip() else f"exit {made.returncode}"}
    return {key: math.inf if value is None else value for key, value in json.loads(made.stdout).items()}


def text_of(of):
    if of is None:
        return ""
    if "failed" in of:
        return of["failed"]
    triangles = "" if of["triangles"] == of["expected"] else f" ({of['triangles']} of {of['expected']} triangles)"
    clips = "" if of["poses_without_clip"] == 0 else f" ({of['poses_without_clip']} poses without clip)"
    return f"rest {of['at_rest']:.1e} motion {of['in_motion']:.1e} {of['worst']} area {of['area']:.0e} " \
           f"volume {of['volume']:.0e}{triangles}{clips}"


def error_of(of):
    if of is None or "failed" in of:
        return "refused"
    error = max(of["at_rest"], of["in_motion"])
    missing = of["expected"] - of["triangles"]
    return ("-" if error > 1e9 else f"{error:.1e}") + (f", {missing} triangle{'' if missing == 1 else 's'} missing" if missing else "")


def markdown(rows):
    """The table of docs/reference/importing.md."""
    print("| file | triangles | clips | `foredraw-import` | FBX2glTF |\n|---|---|---|---|---|")
    for row in rows:
        ours = row.get("foredraw", {})
        print(f"| {row['file']} | {ours.get('expected', '')} | {ours.get('clips', '')} | {error_of(row.get('foredraw'))} "
              f"| {error_of(row.get('fbx2gltf'))} |")


def is_within(of, limit):
    return of is not None and "failed" not in of and of["triangles"] == of["expected"] \
        and max(of["at_rest"], of["in_motion"]) <= limit


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("build", type=Path)
    options.add_argument("ufbx", type=Path)
    options.add_argument("files", type=Path, nargs="+")
    options.add_argument("--fbx2gltf", type=Path)
    options.add_argument("--poses", type=int, default=9)
    options.add_argument("--limit", type=float, default=1e-3)
    options.add_argument("--markdown", action="store_true", help="prints a table, too")
    options.add_argument("--json", type=Path, help="writes all figures there")
    args = options.parse_args()
    bench = args.build / "benchmarks/importing/imported-poses-bench"
    os.environ.setdefault("FOREDRAW_IMPORTER", str((args.build / "hosts/cli/foredraw-import").absolute()))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        source = Path(__file__).parent / "ufbx_poses.c"
        subprocess.run(["cc", "-O1", "-I", args.ufbx, source, args.ufbx / "ufbx.c", "-lm", "-o", work / "ufbx_poses"],
                       check=True)
        for file in args.files:
            row = {"file": file.name}
            rows.append(row)
            referee = run([work / "ufbx_poses", file, work / "referee", args.poses])
            if referee.returncode != 0:
                row["ufbx"] = referee.stderr.strip()
            else:
                row["foredraw"] = figures(bench, file, work / "referee")
                if args.fbx2gltf:
                    out = work / "other.glb"
                    out.unlink(missing_ok=True)
                    made = run([args.fbx2gltf.absolute(), "--binary", "--input", file.absolute(), "--output", out])
                    row["fbx2gltf"] = figures(bench, out, work / "referee") if out.exists() else \
                        {"failed": "FBX2glTF: exit " + str(made.returncode)}
            print(f"{file.name}\n    foredraw: {row.get('ufbx') or text_of(row.get('foredraw'))}", flush=True)
            if "fbx2gltf" in row:
                print(f"    FBX2glTF: {text_of(row['fbx2gltf'])}", flush=True)
    asked = [row for row in rows if "foredraw" in row]
    for name in ["foredraw", "fbx2gltf"]:
        within = sum(is_within(row.get(name), args.limit) for row in asked)
        if any(name in row for row in rows):
            print(f"{name}: {within} of {len(asked)} files within {args.limit} of ufbx")
    if args.markdown:
        markdown(asked)
    if args.json:
        args.json.write_text(json.dumps(rows, indent=1))


if __name__ == "__main__":
    main()
