#!/usr/bin/env python3
"""Runs a pipeline over every model below some folders: what is accepted, mended, refused and why, in which time.

real_files.py PROGRAM FOLDER... [--pipeline @default] [--validator FOLDER] [--list FILE.tsv] [--jobs 2]

Nothing below the folders is changed. With --validator, a folder in which tests/validator/install has run, the Khronos
validator says of each glTF whether the output has errors that the input has not.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

KINDS = {".glb", ".gltf", ".vrm", ".obj", ".ply", ".off", ".stl"}
GLTF = {".glb", ".gltf", ".vrm"}
MISSING = re.compile(r"there is no file '.*' in the folder of the glTF")


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


def run(job):
    path, arguments = job
    row = {"file": str(path), "mended": [], "new_errors": "", "reason": ""}
    with tempfile.TemporaryDirectory() as folder:
        made, report = f"{folder}/made.glb", f"{folder}/report.json"
        command = [arguments.program, "optimize", str(path), "-o", made, "--report", report, "-p", arguments.pipeline]
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
        elif arguments.validator and path.suffix.lower() in GLTF:
            before_and_after = errors_of(arguments.validator, [path.resolve(), made])
            if before_and_after:
                before, after = before_and_after
                row["new_errors"] = " ".join(code for code in after if after[code] > before.get(code, 0))
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--pipeline", default="@default")
    parser.add_argument("--validator")
    parser.add_argument("--list", help="write a row for each file")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    if arguments.validator:
        arguments.validator = os.path.abspath(arguments.validator)

    files = list(models(arguments.folders))
    if not files:
        sys.exit(f"there are no models below {', '.join(arguments.folders)}")
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        rows = list(pool.map(run, ((path, arguments) for path in files)))

    verdicts = collections.Counter(row["verdict"] for row in rows)
    mended = collections.Counter(code for row in rows for code in row["mended"])
    print(f"{len(rows)} files: " + ", ".join(f"{count} {verdict}" for verdict, count in verdicts.most_common()))
    print(f"{sum(bool(row['mended']) for row in rows)} accepted with warnings")
    if arguments.validator:
        print(f"{sum(bool(row['new_errors']) for row in rows)} with new errors of the validator")
    slowest = max(rows, key=lambda row: row["seconds"])
    largest = max(rows, key=lambda row: row["megabytes"])
    print(f"{sum(row['seconds'] for row in rows):.0f} seconds; at most {slowest['seconds']:.1f} ({slowest['file']}); "
          f"at most {largest['megabytes']:.0f} MB ({largest['file']})")
    for heading, counts in (("warnings", mended),
                            ("reasons", collections.Counter((row["verdict"], row["reason"]) for row in rows
                                                            if row["verdict"] != "accepted")),
                            ("new errors", collections.Counter(row["new_errors"] for row in rows if row["new_errors"]))):
        if counts:
            print(f"\n{heading}:")
        for what, count in counts.most_common():
            print(f"{count:6} {what if isinstance(what, str) else ': '.join(what)}")
    if arguments.list:
        with open(arguments.list, "w", encoding="utf-8") as text:
            text.write("file\tverdict\tseconds\tmegabytes\treason\twarnings\tnew errors\n")
            for row in rows:
                text.write(f"{row['file']}\t{row['verdict']}\t{row['seconds']:.3f}\t{row['megabytes']:.0f}\t"
                           f"{row['reason']}\t{' '.join(row['mended'])}\t{row['new_errors']}\n")


if __name__ == "__main__":
    main()
