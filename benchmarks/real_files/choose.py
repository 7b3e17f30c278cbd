#!/usr/bin/env python3
"""Draws models from collections, in the same way for everybody who has the same collections.

choose.py FOLDER... [--each 30] [--count 1000] [--smaller-than BYTES] > FILES.txt

Each folder is one collection. Of models with equal bytes the first one counts. They are sorted by the SHA-256 of their
bytes: the first `each` of every collection take part, and the first `count` of those are drawn.
"""

import argparse
import hashlib
import pathlib

from real_files import models


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--each", type=int, default=30)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--smaller-than", type=int, default=4 << 20)
    arguments = parser.parse_args()

    seen, drawn = set(), []
    for folder in sorted(arguments.folders):
        own = []
        for path in models([folder]):
            if path.stat().st_size >= arguments.smaller_than:
                continue
            digest = hashlib.sha256(path.read_bytes()).hexdigest()
            if digest not in seen:
                seen.add(digest)
                own.append((digest, path))
        drawn += sorted(own)[: arguments.each]
    print(*(path for _, path in sorted(drawn)[: arguments.count]), sep="\n")


if __name__ == "__main__":
    main()
