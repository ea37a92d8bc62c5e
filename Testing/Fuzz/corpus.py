#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
"""Packs the inputs of fuzz targets into archives, Testing/Fuzz/Corpus/<Target>.zip.

    corpus.py pack ARCHIVE FOLDER     make the archive of all files in the folder
    corpus.py add ARCHIVE FILE...     add files to the archive
    corpus.py unpack ARCHIVE FOLDER   write the files of the archive into the folder
    corpus.py check                   check that all archives are as this program makes them

The same inputs always give the same bytes: inputs are named after their SHA-1, as libFuzzer does,
sorted, stored without compression, and carry no time. Other programs can read the archives.
"""

import argparse
import hashlib
import io
import pathlib
import sys
import zipfile

CORPUS = pathlib.Path(__file__).resolve().parent / "Corpus"


def make_archive(inputs):
    """The bytes of the archive of the inputs."""
    named = {hashlib.sha1(data).hexdigest()[:12]: data for data in inputs}
    if len(named) != len(set(inputs)):
        sys.exit("two different inputs get the same name")
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_STORED) as archive:
        for name, data in sorted(named.items()):
            info = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            info.create_system = 3  # Unix, on every system
            info.external_attr = 0o100644 << 16
            archive.writestr(info, data)
    return out.getvalue()


def read_archive(path):
    """The files of the archive, by name."""
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def pack(arguments):
    files = [path for path in arguments.folder.rglob("*") if path.is_file()]
    if not files:
        sys.exit(f"{arguments.folder}: no files")
    arguments.archive.write_bytes(make_archive([path.read_bytes() for path in files]))
    report(arguments.archive)


def add(arguments):
    inputs = list(read_archive(arguments.archive).values())
    inputs += [path.read_bytes() for path in arguments.file]
    arguments.archive.write_bytes(make_archive(inputs))
    report(arguments.archive)


def unpack(arguments):
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for name, data in read_archive(arguments.archive).items():
        (arguments.folder / pathlib.PurePath(name).name).write_bytes(data)


def check(_):
    archives = sorted(CORPUS.glob("*.zip"))
    wrong = [path for path in archives
             if make_archive(read_archive(path).values()) != path.read_bytes()]
    for path in wrong:
        print(f"{path}: not as corpus.py makes it", file=sys.stderr)
    print(f"{len(archives)} archives of fuzz inputs, {len(wrong)} problems")
    return 1 if wrong or not archives else 0


def report(archive):
    files = read_archive(archive)
    print(f"{archive}: {len(files)} inputs, {sum(map(len, files.values()))} bytes")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    for function, operand in ((pack, "folder"), (add, "file"), (unpack, "folder"), (check, None)):
        command = commands.add_parser(function.__name__)
        command.set_defaults(run=function)
        if operand:
            command.add_argument("archive", type=pathlib.Path)
            command.add_argument(operand, type=pathlib.Path,
                                 nargs="+" if operand == "file" else None)
    arguments = parser.parse_args()
    return arguments.run(arguments)


if __name__ == "__main__":
    sys.exit(main())
