# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""An authority of tests and certificates that it signs, by the program openssl. No system trusts it."""

import os
import subprocess


class Authority:
    """Its own certificate is ``path``."""

    def __init__(self, folder):
        self._folder = folder
        self.path = self._find("authority.pem")
        self._run("req", "-x509", *self._new_key("authority"), "-subj", "/CN=Authority of tests", "-days", "2",
                  "-addext", "keyUsage=critical,keyCertSign", "-out", self.path)

    def sign(self, name, hosts):
        """A certificate for hosts such as ``"IP:127.0.0.1"``, and its key, as two paths."""
        request, extensions, path = (self._find(name + end) for end in (".csr", ".ext", ".pem"))
        with open(extensions, "w", encoding="ascii") as file:
            file.write(f"subjectAltName={hosts}\nauthorityKeyIdentifier=keyid\nbasicConstraints=critical,CA:FALSE\n")
        self._run("req", *self._new_key(name), "-subj", f"/CN={name}", "-out", request)
        self._run("x509", "-req", "-in", request, "-CA", self.path, "-CAkey", self._find("authority.key"),
                  "-CAcreateserial", "-days", "2", "-extfile", extensions, "-out", path)
        return path, self._find(name + ".key")

    def _find(self, name):
        return os.path.join(self._folder, name)

    def _new_key(self, name):
        return ("-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-keyout",
                self._find(name + ".key"))

    @staticmethod
    def _run(*arguments):
        subprocess.run(["openssl", *arguments], check=True, capture_output=True)
