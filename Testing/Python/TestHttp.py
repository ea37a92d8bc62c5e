# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files on web servers: only what is needed is fetched, and each kind of bad server has its message."""

import os
import pathlib
import shutil
import threading
import unittest
import unittest.mock

os.environ["no_proxy"] = "*"

import gatun  # noqa: E402
import numpy as np  # noqa: E402
from gatunCertificates import Authority  # noqa: E402
from gatunCube import find, make_cube, require_equal, require_raises  # noqa: E402
from gatunGrids import golden_files, require_same_grids  # noqa: E402
from gatunServer import Server  # noqa: E402

BLOCK = 65536


def write_large():
    """A file of some 100 blocks, with chunks, arrays and coarser meshes."""
    points, tets = make_cube(45)
    generator = np.random.default_rng(1)
    data = {name: generator.normal(size=len(points)) for name in ("a", "b", "c", "d")}
    path = find("large.gtn")
    gatun.write(gatun.Mesh(points, tets, data), path, chunk_size=4096, levels=2, overwrite=True)
    return path


class Http(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.path = write_large()
        cls.data = pathlib.Path(cls.path).read_bytes()
        assert len(cls.data) > 40 * BLOCK, len(cls.data)

    def test_golden_files(self):
        for path in golden_files(".gtn")[::6]:
            with Server(pathlib.Path(path).read_bytes()) as server, gatun.open(server.url) as file:
                with gatun.open(path) as other:
                    require_same_grids(file.read(), other.read())
        for path in golden_files(".ghv")[::4]:
            with Server(pathlib.Path(path).read_bytes()) as server, gatun.open(server.url) as volume:
                with gatun.open(path) as other:
                    require_equal(volume.read(), other.read())

    def test_amounts(self):
        """Description, a coarser mesh and a box need few requests and a part of the file."""
        with gatun.open(self.path) as local:
            level, box = local.read(level=2, arrays=[]), local.read(box=(0, 0.1) * 3, arrays="b")
            plan = sum(length for _, length in local.plan(box=(0, 0.1) * 3, arrays="c"))
            contour = local.contour("a", 3.0)
        with Server(self.data) as server:

            def count(work):
                source = gatun.HttpSource(server.url)
                with gatun.open(source) as file:
                    result = work(file)
                self.assertEqual(source.requests, len(server.http.log))
                server.http.log.clear()
                return result, source.requests, source.bytes_fetched

            _, requests, amount = count(lambda file: (file.info, file.arrays, file.times))
            self.assertLessEqual(requests, 5)
            self.assertLessEqual(amount, 7 * BLOCK)
            grid, requests, amount = count(lambda file: file.read(level=2, arrays=[]))
            require_same_grids(grid, level)
            self.assertLessEqual(requests, 6)
            self.assertLess(amount, len(self.data) / 4)
            grid, requests, amount = count(lambda file: file.read(box=(0, 0.1) * 3, arrays="b"))
            require_same_grids(grid, box)
            self.assertLess(amount, max(plan, len(self.data) / 4))
            grid, requests, amount = count(lambda file: file.contour("a", 3.0))
            require_same_grids(grid, contour)
            grid, requests, amount = count(lambda file: file.read())
            with gatun.open(self.path) as local:
                require_same_grids(grid, local.read())
            self.assertLessEqual(amount, len(self.data))
            self.assertLessEqual(requests, 12)

    def test_steps(self):
        """A file with more steps needs no more requests to be described."""

        def count(steps):
            points, tets = make_cube(20)
            path = find(f"steps{steps}.gtn")
            generator = np.random.default_rng(1)
            with gatun.Writer(path, levels=2, boundary=True, overwrite=True) as writer:
                writer.add_mesh(points, tets)
                for step in range(steps):
                    writer.write_step(point_data={"a": generator.normal(size=len(points))}, time=step)
            with Server(pathlib.Path(path).read_bytes()) as server, gatun.open(server.url) as file:
                self.assertEqual(len(file.info["times"]), steps)
                return len(server.http.log)

        self.assertEqual(count(40), count(20))
        self.assertLessEqual(count(40), 6)

    def test_store(self):
        """What has been fetched is kept up to a limit, and read once."""
        with Server(self.data) as server:
            source = gatun.HttpSource(server.url)
            for _ in range(3):
                self.assertEqual(source.read(100, 3 * BLOCK), self.data[100 : 100 + 3 * BLOCK])
            self.assertEqual(source.requests, 2)
            self.assertEqual(source.read(len(self.data) - 7, 100), self.data[-7:])
            self.assertEqual(source.read(len(self.data) + 7, 100), b"")
            self.assertEqual(source.requests, 3)
            source.fetch([(20 * BLOCK, 5), (21 * BLOCK, 5), (30 * BLOCK, BLOCK)])
            self.assertEqual(source.requests, 5)  # two runs of blocks
            source.read(20 * BLOCK + 9, 2 * BLOCK - 9)
            self.assertEqual(source.requests, 5)
            small = gatun.HttpSource(server.url, cache_bytes=2 * BLOCK)
            self.assertEqual(small.read(0, 9 * BLOCK), self.data[: 9 * BLOCK])
            self.assertEqual(small.read(8 * BLOCK, BLOCK), self.data[8 * BLOCK : 9 * BLOCK])
            self.assertEqual(small.requests, 2)
            small.read(0, BLOCK)
            self.assertEqual(small.requests, 3)
            with gatun.open(small) as file, gatun.open(self.path) as local:
                require_same_grids(file.read(), local.read())

    def test_threads(self):
        """Threads that need the same blocks fetch them once."""
        with Server(self.data) as server:
            source = gatun.HttpSource(server.url)
            wanted = 10 * BLOCK
            threads = [threading.Thread(target=source.read, args=(BLOCK, wanted)) for _ in range(4)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            self.assertEqual(source.bytes_fetched, wanted + BLOCK)
            self.assertLessEqual(len({headers["Range"] for _, headers in server.http.log}), 3)

    def test_headers(self):
        with Server(self.data) as server:
            gatun.HttpSource(server.url, headers={"Authorization": "Bearer x"})
            headers = server.http.log[0][1]
            self.assertEqual((headers["Authorization"], headers["Accept-Encoding"]), ("Bearer x", "identity"))

    def test_bad_servers(self):
        for mode, text in [
            ("ignores ranges", "does not answer range requests"),
            ("compresses", "compresses the file (gzip)"),
            ("compresses parts", "compresses the file (br)"),
            ("no range", "does not tell which part"),
            ("unknown size", "does not tell which part"),
        ]:
            with self.subTest(mode), Server(self.data, mode) as server:
                error = require_raises(gatun.Error, text, gatun.open, server.url)
                self.assertTrue(str(error).startswith(server.url))
        for mode, kind, text in [
            ("another part", gatun.Error, "another part"),
            ("breaks off", OSError, "in place of"),
            ("sends less", gatun.Error, "in place of"),
        ]:
            with self.subTest(mode), Server(self.data, mode) as server:
                source = gatun.HttpSource(server.url)
                require_raises(kind, text, source.read, BLOCK, BLOCK)
                self.assertEqual(len(server.http.log), 4 if mode == "breaks off" else 2)
                require_raises(kind, text, gatun.File, source)
        for mode, kind in [("404", FileNotFoundError), ("403", PermissionError), ("503", OSError)]:
            with self.subTest(mode), Server(self.data, mode) as server:
                error = require_raises(kind, f"the server says {mode}", gatun.open, server.url)
                self.assertEqual(error.filename, server.url)
                self.assertEqual(len(server.http.log), 3 if mode == "503" else 1)
        with Server(self.data, "busy") as server, gatun.open(server.url) as file:
            file.info  # pylint: disable=pointless-statement
        with Server(b"") as server:
            require_raises(gatun.Error, server.url, gatun.File, gatun.HttpSource(server.url))
            url = server.url
        require_raises(ConnectionRefusedError, url, gatun.open, url)

    def test_changed(self):
        """A file that is replaced meanwhile is noticed, with each way to tell its version."""
        first, second = "Mon, 01 Jan 2024 00:00:00 GMT", "Tue, 02 Jan 2024 00:00:00 GMT"
        for tag, new_tag, date, new_date in [
            ('"one"', '"two"', None, None),
            ('W/"one"', 'W/"two"', None, None),
            (None, None, first, second),
            (None, None, None, None),
        ]:
            with self.subTest(tag=tag, date=date), Server(self.data, tag=tag, date=date) as server:
                source = gatun.HttpSource(server.url)
                with gatun.open(source) as file:
                    file.info  # pylint: disable=pointless-statement
                    server.http.data, server.http.tag, server.http.date = self.data + b"more", new_tag, new_date
                    require_raises(gatun.Error, "has changed", file.read)

    def test_redirects(self):
        with Server(self.data) as server:
            url = server.url.replace("/file", "/old")
            with gatun.open(url) as file, gatun.open(self.path) as local:
                require_same_grids(file.read(arrays=[]), local.read(arrays=[]))
            self.assertTrue(all("Range" in headers for _, headers in server.http.log))
            for target in ("ftp://127.0.0.1/file", "file:///etc/hostname", "/old"):
                server.http.target = target
                with self.subTest(target):
                    with self.assertRaises((gatun.Error, OSError)):
                        gatun.open(url)

    @unittest.skipUnless(shutil.which("openssl"), "needs openssl")
    def test_certificates(self):
        """https works with a certificate by an authority that is trusted, and for this host only."""
        os.makedirs(find("certificates"), exist_ok=True)
        authority = Authority(find("certificates"))
        good = authority.sign("good", "IP:127.0.0.1")
        trusted = unittest.mock.patch.dict(os.environ, SSL_CERT_FILE=authority.path)
        with Server(self.data, certificate=good) as server:
            error = require_raises(OSError, "let the environment variable SSL_CERT_FILE name", gatun.open, server.url)
            self.assertEqual(error.filename, server.url)
            self.assertEqual(server.http.log, [])
            with trusted, gatun.open(server.url) as file, gatun.open(self.path) as local:
                require_same_grids(file.read(arrays=[]), local.read(arrays=[]))
            with trusted, Server(self.data) as other:
                server.http.target = other.url
                require_raises(gatun.Error, "is not safe", gatun.open, server.url.replace("/file", "/old"))
                self.assertEqual(other.http.log, [])
                other.http.target = server.url
                with gatun.open(other.url.replace("/file", "/old")) as file:
                    self.assertEqual(file.info["points"], 45**3)
                address = other.url.replace("http:", "https:")
                require_raises(OSError, "there is no secure connection", gatun.open, address)
        with trusted, Server(self.data, certificate=authority.sign("other", "DNS:example.org")) as server:
            require_raises(OSError, "'127.0.0.1'; use a name that it has", gatun.open, server.url)
            self.assertEqual(server.http.log, [])


if __name__ == "__main__":
    unittest.main()
