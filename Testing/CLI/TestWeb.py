# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Commands read addresses of web servers as they read files, fetch only what they need, and have a message
for each kind of bad server."""

import os
import pathlib
import shutil
import sys

import numpy as np
from gatunCli import enter_folder, gtn, lattice, make_grid, write
from gatunPictures import read_png
from gatunVolumes import field, make_image, write_image

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Python"))

from gatunCertificates import Authority  # noqa: E402
from gatunServer import Server  # noqa: E402

os.environ["no_proxy"] = "*"
os.environ["GTN_TIMEOUT"] = "1"
BLOCK = 65536

enter_folder("web")
random = np.random.default_rng(1)
points, tets = lattice(33)
arrays = {name: random.normal(size=len(points)) for name in ("a", "b", "c")}
arrays["x"] = points[:, 0]
write(make_grid(points, tets, arrays), "mesh.vtu")
gtn("pack", "-q", "--chunk-size", "4096", "--levels", "2", "mesh.vtu", "mesh.gtn")
write_image(make_image(field((40, 48, 56))), "scan.vti")
gtn("volume", "pack", "-q", "scan.vti", "scan.ghv")
MESH = pathlib.Path("mesh.gtn").read_bytes()
SCAN = pathlib.Path("scan.ghv").read_bytes()
assert len(MESH) > 25 * BLOCK, len(MESH)


def serve(data=MESH, mode="good", name="mesh.gtn", **options):
    return Server(data, mode, name=name, **options)


def contents(name):
    """The bytes of a file, of a picture without the command that made it."""
    return read_png(name).tobytes() if name.endswith(".png") else pathlib.Path(name).read_bytes()


def same(name, *before_in, out, data=MESH, after_in=(), requests=None, amount=None):
    """A command writes the same for the address as for the file. It may need so many requests and bytes."""
    gtn(*before_in, name, *after_in, "local" + out)
    with serve(data, name=name) as server:
        gtn(*before_in, server.url, *after_in, "remote" + out)
        log = server.http.log
    assert contents("remote" + out) == contents("local" + out), before_in
    ranges = [tuple(map(int, headers["Range"][6:].split("-"))) for _, headers in log]
    total = sum(min(last + 1, len(data)) - first for first, last in ranges)
    print(f"{len(log)} requests, {total} of {len(data)} bytes")
    assert total <= (len(data) if amount is None else amount), f"{before_in}: {total} of {len(data)} bytes"
    assert requests is None or len(log) <= requests, f"{before_in}: {len(log)} requests"


def describe(name, data, *command, requests, amount):
    """What a command prints about an address is what it prints about the file."""
    local = gtn(*command, name)
    with serve(data, name=name) as server:
        remote = gtn(*command, server.url)
        log = server.http.log
    assert remote.replace(server.url, name) == local, (remote, local)
    assert len(log) <= requests, log
    assert len(log) * BLOCK <= amount, log
    return log


# The same as of files, from a part of their bytes.
log = describe("mesh.gtn", MESH, "info", requests=5, amount=6 * BLOCK)
assert log[0][1]["Range"] == f"bytes=0-{BLOCK - 1}" and log[0][1]["Accept-Encoding"] == "identity", log[0]
assert "If-Range" not in log[0][1] and log[1][1]["If-Range"] == '"one"', log
describe("mesh.gtn", MESH, "info", "--json", requests=5, amount=6 * BLOCK)
describe("mesh.gtn", MESH, "verify", requests=200, amount=2**40)
describe("scan.ghv", SCAN, "volume", "info", "--verify", requests=20, amount=2**40)
same("mesh.gtn", "unpack", "-q", "-f", out=".vtu", requests=14)
same("mesh.gtn", "unpack", "-q", "-f", "--arrays", "b", out=".vtu", amount=0.6 * len(MESH), requests=12)
same("mesh.gtn", "simplify", "-q", "-f", "--ratio", "0.95", out=".vtu", amount=0.6 * len(MESH), requests=12)
same("mesh.gtn", "contour", "-q", "-f", "--array", "x", "--value", "3", out=".vtp", amount=0.8 * len(MESH),
     requests=14)
same("mesh.gtn", "render", "-q", "-f", "--array", "a", "--size", "64x48", out=".png", requests=14)
same("mesh.gtn", "pack", "-q", "-f", "--chunk-size", "4096", out=".gtn")
same("scan.ghv", "volume", "unpack", "-q", "-f", out=".vti", data=SCAN, requests=8)
same("scan.ghv", "volume", "render", "-q", "-f", "--size", "64x48", out=".png", data=SCAN)
with serve() as server:
    gtn("verify", server.url + "?download=1", "mesh.vtu", says="identical")
    server.http.target = "/mesh.gtn?here"
    gtn("info", server.url.replace("/mesh.gtn", "/old.gtn"), says="tetrahedra")
    assert all("Range" in headers for _, headers in server.http.log)
    for target, text in (
        ("ftp://127.0.0.1/mesh.gtn", "the server redirects to ftp://127.0.0.1/mesh.gtn, which is not safe"),
        ("file:///etc/hostname", "the server redirects to file:///etc/hostname, which is not safe"),
        ("/old.gtn", "the server redirects without end"),
    ):
        server.http.target = target
        gtn("info", server.url.replace("/mesh.gtn", "/old.gtn"), code=1, says="/old.gtn: " + text)

# Bad servers.
for mode, text in (
    ("ignores ranges", "the server does not answer range requests, by which parts of a file are fetched"),
    ("compresses", "the server compresses the file (gzip), so that no part of it can be had"),
    ("compresses parts", "the server compresses the file (br), so that no part of it can be had"),
    ("no range", "the server does not tell which part of the file it sends, and its size"),
    ("unknown size", "the server does not tell which part of the file it sends, and its size"),
    ("sends more", f"the server has sent more than {BLOCK} bytes"),
    ("another part", "the server sends another part of the file than it was asked for"),
    ("wrong size", "the file on the server has changed since it was opened"),
    ("breaks off", "the server has sent "),
    ("sends less", "the server has sent "),
    ("changes", "the file on the server has changed since it was opened"),
    ("no answer", ""),
    ("silent", "the server does not answer in time"),
    ("404", "the server says 404 Not Found"),
    ("403", "the server says 403 Forbidden"),
    ("503", "the server says 503 Service Unavailable"),
):
    with serve(mode=mode) as server:
        gtn("info", server.url, code=1, says=f"gtn: {server.url}: {text}")
        assert len(server.http.log) <= 4, (mode, len(server.http.log))
    assert not os.path.exists("new.vtu")
with serve(mode="busy") as server:
    gtn("info", server.url, says="tetrahedra")
    server.http.log.clear()
    server.http.mode = "changes"
    gtn("unpack", server.url, "new.vtu", code=1, says="has changed since it was opened")
    assert not os.path.exists("new.vtu")
with serve(b"") as server:
    gtn("info", server.url, code=1, says=f"gtn: {server.url}: the file is empty")
gtn("info", server.url, code=1, says=f"gtn: {server.url}: ")  # nobody answers there now
with serve(b"this is no mesh\n" * 20) as server:
    gtn("info", server.url, code=1, says=f"gtn: {server.url}: this is not a .gtn file")
with serve(MESH[: len(MESH) // 2]) as server:
    gtn("unpack", server.url, "new.vtu", code=1, says=f"gtn: {server.url}: the file does not end as it should")

# Certificates: by the authorities of the system only.
if shutil.which("openssl"):
    os.mkdir("certificates")
    with serve(certificate=Authority("certificates").sign("server", "IP:127.0.0.1")) as server:
        gtn("info", server.url, code=1, says=f"gtn: {server.url}: ")
        gtn("info", server.url, code=1, says="must be for this host, and by an issuer that the system trusts")
        assert not server.http.log, server.http.log

# What gtn does not do.
for command in (("pack", "https://127.0.0.1:1/mesh.vtu", "new.gtn"), ("info", "http://127.0.0.1:1/mesh")):
    gtn(*command, code=1, says=f"gtn: {command[1]}: only files whose names end in .gtn or .ghv are read from web")
gtn("pack", "-q", "mesh.vtu", "https://127.0.0.1:1/mesh.gtn", code=1, says="https://127.0.0.1:1/mesh.gtn")
gtn("info", "http://127.0.0.1:1/a.gtn", code=2, says="GTN_TIMEOUT", env={**os.environ, "GTN_TIMEOUT": "soon"})

# Without libcurl.
os.mkdir("none")
for name in ("libcurl.so.4", "libcurl-gnutls.so.4"):
    pathlib.Path("none", name).write_text("not a library\n" * 100)
without = {**os.environ, "LD_LIBRARY_PATH": os.path.abspath("none")}
gtn("info", "http://127.0.0.1:1/a.gtn", code=1, says="by libcurl.so.4, which is not installed", env=without)
gtn("info", "-q", "mesh.gtn", env=without)
