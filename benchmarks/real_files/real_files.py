#!/usr/bin/env python3
"""Runs a pipeline over every model below some folders: what is accepted, mended, refused and why, in which time.

real_files.py PROGRAM FOLDER... [--files LIST [--root FOLDER]] [--pipeline @default] [--validator FOLDER]
              [--viewer FOLDER] [--pictures 100] [--seed 1] [--kept FOLDER] [--list FILE.tsv] [--jobs 2]

LIST names files, one a line, in place of folders. A model may name files of its folder in the command line and below,
or of --root. Nothing below the folders is changed.

With --validator, a folder with package.json of tests/validator in which tests/npm_ci has run, the Khronos validator says of each glTF whether the
output has errors that the input has not. With --viewer, a folder in which viewer/install has run, three.js says which
files show, and whether so many of the outputs, drawn by the seed, give the same pictures as their inputs. Pictures that
differ are kept in FOLDER.
"""

import argparse
import collections
import concurrent.futures
import itertools
import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

KINDS = {".glb", ".gltf", ".vrm", ".obj", ".ply", ".off", ".stl"}
GLTF = {".glb", ".gltf", ".vrm"}
SAME = 0.001  # of the pixels that a view covers, so many may differ
MISSING = re.compile(r"buffers\[\d+\]\.uri: '.*' is missing")


def models(folders):
    for folder in folders:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.suffix.lower() in KINDS and path.is_file():
                yield path


def reason_in(text):
    """The first error, without what is this file's own."""
    for line in text.splitlines():
        if "error: " not in line:
            continue
        message = line.split("error: ", 1)[1]
        message = re.sub(r"'[^']*'", "'...'", message)
        return re.sub(r" \(and \d+ more like it\)$", "", re.sub(r"\d+", "N", message))
    return "no reason"


def errors_of(validator, files):
    """Of each file, {code: count}; None where the validator cannot be asked."""
    asked = subprocess.run(["node", "validate.mjs", *map(str, files)], cwd=validator, capture_output=True, text=True)
    if asked.returncode != 0:
        return None
    return [record["errors"] for record in json.loads(asked.stdout)]


def ask_validator(rows, arguments):
    """Adds to each row of an accepted glTF the codes of errors that the output has more of than the input."""
    left = [row for row in rows if row["verdict"] == "accepted" and pathlib.Path(row["file"]).suffix.lower() in GLTF]
    parts = [left[i:i + 20] for i in range(0, len(left), 20)]
    for part in parts:
        found = errors_of(arguments.validator, [row[key] for row in part for key in ("file", "made")])
        if found is None and len(part) > 1:  # one of them brings the validator down
            parts += [[row] for row in part]
            continue
        for row, before, after in zip(part, (found or [])[::2], (found or [])[1::2]):
            row["new_errors"] = " ".join(code for code in after if after[code] > before.get(code, 0))


def looks(viewer, jobs, kept=None):
    """What three.js says of each job; viewer/look.mjs tells what that is."""
    asked = subprocess.run(["node", "look.mjs", *([kept] if kept else [])], cwd=viewer, text=True,
                           input="".join(json.dumps(job) + "\n" for job in jobs), stdout=subprocess.PIPE)
    if asked.returncode != 0:
        sys.exit(f"{viewer}: three.js cannot be asked")
    return [json.loads(line) for line in asked.stdout.splitlines()]


def ask_viewer(rows, arguments):
    """Adds to each row whether the file `shows`, with `pictures` where they were compared."""
    jobs = [{"before": row["file"]} for row in rows]
    half = (len(jobs) + 1) // 2
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        parts = pool.map(looks, [arguments.viewer] * 2, [jobs[:half], jobs[half:]])
        for row, found in zip(rows, itertools.chain.from_iterable(parts)):
            row["shows"] = found["shows"]
            row["unseen"] = found.get("reason", "")
    both = [row for row in rows if row["shows"] and row["verdict"] == "accepted"]
    drawn = random.Random(arguments.seed).sample(both, min(arguments.pictures, len(both)))
    jobs = [{"before": row["file"], "after": row["made"]} for row in drawn]
    for row, found in zip(drawn, looks(arguments.viewer, jobs, arguments.kept)):
        views = found.get("views", [])
        row["pictures"] = max((view["differing"] / max(view["covered"], 1) for view in views), default=1.0)
        if row["pictures"] > SAME:
            row["verdict"], row["reason"] = "differs", found.get("reason", "it draws another picture")


def run(job):
    path, root, folder, arguments = job
    row = {"file": str(path.resolve()), "mended": [], "new_errors": "", "reason": ""}
    made, report = f"{folder}.glb", f"{folder}.json"
    row["made"] = made
    command = [arguments.program, "optimize", str(path), "-o", made, "--report", report, "-p", arguments.pipeline]
    command += ["--root", root] if root else []
    began = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    told = child.stderr.read().decode(errors="replace")
    _, status, used = os.wait4(child.pid, 0)
    row["seconds"] = time.monotonic() - began
    row["megabytes"] = used.ru_maxrss / 1024
    row["code"] = os.waitstatus_to_exitcode(status)
    if row["code"] != 0:
        missing = MISSING.search(told)
        row["verdict"] = "incomplete" if missing else "crashed" if row["code"] < 0 else "refused"
        row["reason"] = "a buffer's file is missing" if missing else reason_in(told)
        return row
    row["verdict"] = "accepted"
    with open(report, encoding="utf-8") as text:
        diagnostics = json.load(text)["diagnostics"]
    row["mended"] = sorted({d["code"] for d in diagnostics if d["severity"] == "warning"})
    again = subprocess.run([arguments.program, "inspect", made], capture_output=True, text=True)
    if again.returncode != 0:
        row["verdict"], row["reason"] = "wrong", "the output cannot be read: " + reason_in(again.stderr)
    return row


def print_summary(rows, arguments):
    verdicts = collections.Counter(row["verdict"] for row in rows)
    mended = collections.Counter(code for row in rows for code in row["mended"])
    print(f"{len(rows)} files: " + ", ".join(f"{count} {verdict}" for verdict, count in verdicts.most_common()))
    print(f"{sum(bool(row['mended']) for row in rows)} accepted with warnings")
    if arguments.validator:
        print(f"{sum(bool(row['new_errors']) for row in rows)} with new errors of the validator")
    reasons = {"reasons": rows}
    if arguments.viewer:
        shown = [row for row in rows if row["shows"]]
        good = [row for row in shown if row["verdict"] == "accepted" and not row["new_errors"]]
        print(f"{len(shown)} show in three.js; {len(good)} of these are accepted without new errors: "
              f"{100 * len(good) / max(len(shown), 1):.2f} per cent")
        compared = [row["pictures"] for row in rows if "pictures" in row]
        print(f"{len(compared)} compared by pictures: {sum(share == 0 for share in compared)} equal, "
              f"{sum(0 < share <= SAME for share in compared)} with up to {SAME:.1%} other pixels, "
              f"{sum(share > SAME for share in compared)} with more")
        reasons = {"reasons of those that show": shown,
                   "reasons of the others": [row for row in rows if not row["shows"]]}
    slowest = max(rows, key=lambda row: row["seconds"])
    largest = max(rows, key=lambda row: row["megabytes"])
    print(f"{sum(row['seconds'] for row in rows):.0f} seconds; at most {slowest['seconds']:.1f} ({slowest['file']}); "
          f"at most {largest['megabytes']:.0f} MB ({largest['file']})")
    tables = {"warnings": mended}
    for heading, of in reasons.items():
        tables[heading] = collections.Counter(f"{row['verdict']}: {row['reason']}" for row in of
                                              if row["verdict"] != "accepted")
    tables["new errors"] = collections.Counter(row["new_errors"] for row in rows if row["new_errors"])
    for heading, counts in tables.items():
        if counts:
            print(f"\n{heading}:")
        for what, count in counts.most_common():
            print(f"{count:6} {what}")


def write_list(rows, path):
    with open(path, "w", encoding="utf-8") as text:
        text.write("file\tverdict\tseconds\tmegabytes\treason\twarnings\tnew errors\tshows\tother pixels\n")
        for row in rows:
            shows = {True: "yes", False: f"no: {row.get('unseen')}", None: ""}[row.get("shows")]
            text.write(f"{row['file']}\t{row['verdict']}\t{row['seconds']:.3f}\t{row['megabytes']:.0f}\t"
                       f"{row['reason']}\t{' '.join(row['mended'])}\t{row['new_errors']}\t{shows}\t"
                       f"{row.get('pictures', '')}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folders", nargs="*")
    parser.add_argument("--files", help="a list of files, one a line")
    parser.add_argument("--root", help="they may name files of this folder and below, beyond their own")
    parser.add_argument("--pipeline", default="@default")
    parser.add_argument("--validator")
    parser.add_argument("--viewer")
    parser.add_argument("--pictures", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kept", type=os.path.abspath)
    parser.add_argument("--list", help="write a row for each file")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    if arguments.validator:
        arguments.validator = os.path.abspath(arguments.validator)

    files = [(path, folder) for folder in arguments.folders for path in models([folder])]
    if arguments.files:
        listed = pathlib.Path(arguments.files).read_text(encoding="utf-8").splitlines()
        files += [(pathlib.Path(path), arguments.root) for path in listed]
    if not files:
        sys.exit("no models are named: give folders, or --files LIST")
    with tempfile.TemporaryDirectory() as made, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        jobs = ((path, root, f"{made}/{number}", arguments) for number, (path, root) in enumerate(files))
        rows = list(pool.map(run, jobs))
        if arguments.validator:
            ask_validator(rows, arguments)
        if arguments.viewer:
            ask_viewer(rows, arguments)
    print_summary(rows, arguments)
    if arguments.list:
        write_list(rows, arguments.list)


if __name__ == "__main__":
    main()
