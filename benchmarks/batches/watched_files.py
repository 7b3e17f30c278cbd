#!/usr/bin/python3
"""What it costs to watch a folder, and how soon a change comes out.

    benchmarks/batches/watched_files.py build/release/hosts/cli/foredraw [--files 10000] [--folder build/watched]

Makes so many small scenes as many_files.py does, fills a cache, then watches them: how long until all are known to be up to
date, what the process holds, which part of a processor it takes while nothing changes, and how long it is from the end of a
write to the line that tells of the output. Prints a table.
"""

import argparse
import os
import re
import shutil
import signal
import statistics
import subprocess
import time
from pathlib import Path

from many_files import PIPELINE, make_files


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("program", type=Path)
    arguments.add_argument("--files", type=int, default=10000)
    arguments.add_argument("--folder", type=Path, default=Path("build/watched"))
    arguments = arguments.parse_args()
    folder = arguments.folder
    shutil.rmtree(folder, ignore_errors=True)
    make_files(folder / "in", arguments.files)
    rest = [folder / "in", "-o", folder / "out", "--cache", folder / "cache", *PIPELINE]
    subprocess.run([arguments.program, "optimize", *rest], check=True, stderr=subprocess.DEVNULL)

    log = folder / "log"
    with open(log, "w") as out:
        begin = time.monotonic()
        watching = subprocess.Popen([arguments.program, "watch", *rest], stdout=out, stderr=out)
    process = Path("/proc") / str(watching.pid)

    def ticks():
        return sum(map(int, (process / "stat").read_text().rpartition(")")[2].split()[11:13]))

    def wait_for(text, times):
        while log.read_text().count(text) < times:
            if watching.poll() is not None:
                raise RuntimeError(log.read_text())
            time.sleep(0.002)
        return time.monotonic()

    try:
        begun = wait_for("up to date", 1) - begin
        before = ticks()
        time.sleep(10)
        idle = (ticks() - before) / os.sysconf("SC_CLK_TCK") / 10
        delays = []
        scenes = sorted((folder / "in").rglob("*.glb"))
        for i in range(20):
            scene = scenes[i * len(scenes) // 20]
            scene.write_bytes(scene.read_bytes() + b"\0" * 4)  # behind the end that the file names: nothing else changes
            delays.append(-time.monotonic() + wait_for(f"{scene.parent.name}/{scene.name}: ", 1))
        peak = int(re.search(r"VmHWM:\s*(\d+)", (process / "status").read_text())[1])
        watching.send_signal(signal.SIGINT)
        begin = time.monotonic()
        code = watching.wait()
        ended = time.monotonic() - begin
    finally:
        watching.kill()
    print(f"files                           {arguments.files}")
    print(f"all known to be up to date      {begun:.2f} s, {1000 * begun / arguments.files:.2f} ms a file")
    print(f"processor while nothing happens {100 * idle:.1f} %")
    print(f"from a write to its line        median {statistics.median(delays):.2f} s, at most {max(delays):.2f} s")
    print(f"peak memory                     {peak / 1024:.0f} MiB")
    print(f"from Ctrl-C to the end          {ended:.2f} s, exit code {code}")


if __name__ == "__main__":
    main()
