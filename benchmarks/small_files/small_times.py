#!/usr/bin/python3
"""Processor time of @small, beside gltfpack.

    benchmarks/small_files/small_times.py build/release/hosts/cli/foredraw GLTFPACK [--rounds=7] [MODEL...]

Each model (default: six of the corpus) goes through `foredraw optimize -p @small --compression khr-meshopt --threads 1` and
`gltfpack -cz -ce khr -kn -km`, one after the other, so many times, so that whatever else the machine does meets both. The
time is what the system charges a process for, in itself and for it; of all rounds the least counts. Prints the table of
docs/results/small-files.md, with the time that `foredraw --version` takes below: what every start of the program costs.
"""

import argparse
import os
import subprocess
import tempfile
from pathlib import Path

CORPUS = Path(__file__).resolve().parent.parent / "corpus"
MODELS = ["static/chess_board_notex.glb", "static/dutch_ship_medium_notex.glb", "static/flight_helmet_notex.glb",
          "animated/kaykit_knight.glb", "animated/quaternius_smooth_female_dress.glb", "static/spot.glb"]


def seconds(command):
    """That the processors worked on the command."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise SystemExit(f"{command[0]} failed: {' '.join(map(str, command))}")
    return usage.ru_utime + usage.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("foredraw")
    parser.add_argument("gltfpack")
    parser.add_argument("models", nargs="*", type=Path)
    parser.add_argument("--rounds", type=int, default=7)
    arguments = parser.parse_args()
    models = arguments.models or [CORPUS / model for model in MODELS]
    print("| model | `@small` | gltfpack | ratio |\n|---|---:|---:|---:|")
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out.glb"
        for model in models:
            ours = [arguments.foredraw, "optimize", model, "-o", out, "-p", "@small", "--compression", "khr-meshopt",
                    "--threads", "1"]
            theirs = [arguments.gltfpack, "-i", model, "-o", out, "-cz", "-ce", "khr", "-kn", "-km"]
            least = [min(times) for times in zip(*((seconds(ours), seconds(theirs)) for _ in range(arguments.rounds)))]
            print(f"| `{model.name}` | {1000 * least[0]:.1f} ms | {1000 * least[1]:.1f} ms | {least[0] / least[1]:.1f} |")
    start = min(seconds([arguments.foredraw, "--version"]) for _ in range(arguments.rounds))
    print(f"\nstart of the program: {1000 * start:.1f} ms")


if __name__ == "__main__":
    main()
