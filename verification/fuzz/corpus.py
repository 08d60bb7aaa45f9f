#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""usage: corpus.py unpack CORPUS FOLDER | pack FOLDER CORPUS

A corpus is one file of all seeds of a target. A line "=== seed NAME" is before each of them and a line break behind it; between these
any bytes are allowed. libFuzzer wants a folder with a file for each seed."""
import sys
from pathlib import Path

MARKER = b"\n=== seed "


def unpack(corpus, folder):
    for seed in (b"\n" + corpus.read_bytes()).removesuffix(b"\n").split(MARKER)[1:]:
        name, _, content = seed.partition(b"\n")
        (folder / name.decode()).write_bytes(content)


def pack(folder, corpus):
    seeds = [MARKER + file.name.encode() + b"\n" + file.read_bytes() for file in sorted(folder.iterdir())]
    corpus.write_bytes(b"".join(seeds).removeprefix(b"\n") + b"\n")


if __name__ == "__main__":
    {"unpack": unpack, "pack": pack}[sys.argv[1]](Path(sys.argv[2]), Path(sys.argv[3]))
