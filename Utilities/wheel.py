#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes a wheel of the Python package with libgatun, which needs no VTK:

    Utilities/wheel.py LIBRARY FOLDER

LIBRARY is a libgatun.so that needs the C library only (Utilities/setup.sh wheel builds one), and FOLDER is where the
wheel is put. There is no compiled extension, so that one wheel is for all versions of Python. Its tag follows from
the newest version of a symbol of the C library that the library needs.
"""

import argparse
import base64
import hashlib
import io
import os
import pathlib
import platform
import re
import subprocess
import sys
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "Python" / "gatun"
OLDEST = 17  # of the C library, 2.17, that a tag can name

#: What a library of a manylinux wheel may need.
SYSTEM_LIBRARIES = {"libc.so.6", "libm.so.6", "libgcc_s.so.1", "libpthread.so.0", "libdl.so.2", "ld-linux-x86-64.so.2",
                    "ld-linux-aarch64.so.1"}

#: Packages of Debian with code that is in the library, whose licenses go with it.
LINKED = ("libglm-dev", "libjsoncpp-dev", "libkissfft-dev", "libstdc++-12-dev", "libxxhash-dev", "libzstd-dev")

WHEEL = """\
Wheel-Version: 1.0
Generator: gatun
Root-Is-Purelib: false
Tag: py3-none-{tag}
"""


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def find_needs(library):
    """The libraries and versions of symbols that a library needs, as ("GLIBC", (2, 34))."""
    libraries = set(re.findall(r"NEEDED\s+(\S+)", run("objdump", "-p", library)))
    versions = set()
    for line in run("objdump", "-T", library).splitlines():
        if "*UND*" in line:
            for name, version in re.findall(r"\b([A-Z][A-Z0-9]*)_([\d.]+)\b", line):
                versions.add((name, tuple(map(int, version.split(".")))))
    return libraries, versions


def find_tag(library):
    """The tag of the platform. Raises SystemExit if the library needs what is not everywhere."""
    libraries, versions = find_needs(library)
    foreign = sorted(libraries - SYSTEM_LIBRARIES)
    if foreign:
        raise SystemExit(f"{library}: needs {', '.join(foreign)}")
    foreign = sorted({name for name, _ in versions} - {"GLIBC", "GCC"})
    if foreign:
        raise SystemExit(f"{library}: needs symbols of {', '.join(foreign)}")
    newest = max([version[1] for name, version in versions if name == "GLIBC"] + [OLDEST])
    return f"manylinux_2_{newest}_{platform.machine()}"


def find_version():
    text = (ROOT / "Module" / "Support" / "gatunVersion.h").read_text(encoding="ascii")
    return ".".join(re.findall(r"#define GATUN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", text))


def make_build(version):
    """The module that CMake writes for a package with classes of VTK."""
    text = (PACKAGE / "_build.py.in").read_text(encoding="utf-8")
    values = {"@PROJECT_VERSION@": version, "@gatun_python_library@": "", "@gatun_python_modules@\n": ""}
    return re.sub("|".join(values), lambda found: values[found[0]], text)


def make_metadata(version):
    text = (ROOT / "Python" / "gatun.dist-info" / "METADATA.in").read_text(encoding="utf-8")
    text = text.replace("@PROJECT_VERSION@", version).replace(", for VTK\n", "\n")
    return text.rstrip("\n") + "\nRequires-Dist: numpy\nLicense-File: LICENSE\n"


def strip(library):
    """The bytes of a library without symbols that nobody needs at run time."""
    with tempfile.TemporaryDirectory() as folder:
        copy = os.path.join(folder, "library")
        run("strip", "--strip-unneeded", "-o", copy, str(library))
        return pathlib.Path(copy).read_bytes()


def list_files(library, version, tag):
    """Pairs of the path in the wheel and the contents."""
    info = f"gatun-{version}.dist-info"
    sources = sorted([*PACKAGE.glob("*.py"), *PACKAGE.glob("vtk/*.py")])
    files = [(f"gatun/{path.relative_to(PACKAGE).as_posix()}", path.read_bytes()) for path in sources]
    files += [
        ("gatun_paraview.py", (PACKAGE.parent / "gatun_paraview.py").read_bytes()),
        ("gatun/_build.py", make_build(version).encode()),
        ("gatun/libgatun.so", strip(library)),
        ("gatun/py.typed", b""),
        (f"{info}/METADATA", make_metadata(version).encode()),
        (f"{info}/entry_points.txt", (ROOT / "Python" / "gatun.dist-info" / "entry_points.txt").read_bytes()),
        (f"{info}/WHEEL", WHEEL.format(tag=tag).encode()),
        (f"{info}/licenses/LICENSE", (ROOT / "LICENSE").read_bytes()),
    ]
    for name in LINKED:
        path = pathlib.Path("/usr/share/doc") / name / "copyright"
        if path.exists():
            files.append((f"{info}/licenses/{name}", path.read_bytes()))
    return info, files


def make_record(info, files):
    """The list of files with their hashes and sizes."""
    lines = []
    for name, data in files:
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        lines.append(f"{name},sha256={digest},{len(data)}\n")
    return "".join(lines) + f"{info}/RECORD,,\n"


def make_wheel(library, folder):
    """Writes the wheel, whose bytes depend on its contents only. Returns its path."""
    version, tag = find_version(), find_tag(library)
    info, files = list_files(library, version, tag)
    files.append((f"{info}/RECORD", make_record(info, files).encode()))
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files:
            entry = zipfile.ZipInfo(name)  # of 1980
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            archive.writestr(entry, data)
    path = pathlib.Path(folder) / f"gatun-{version}-py3-none-{tag}.whl"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(buffer.getvalue())
    return path


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("library", metavar="LIBRARY")
    parser.add_argument("folder", metavar="FOLDER")
    arguments = parser.parse_args()
    path = make_wheel(arguments.library, arguments.folder)
    print(f"{path} ({path.stat().st_size // 1024} KiB)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
