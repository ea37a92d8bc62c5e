# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A web server on the loopback address with one file, good or bad in several ways."""

import gzip
import http.server
import re
import ssl
import sys
import threading
import time


class Handler(http.server.BaseHTTPRequestHandler):
    """Serves ``server.data`` in the manner of ``server.mode``."""

    protocol_version = "HTTP/1.1"

    def log_message(self, *_):
        pass

    def send(self, status, headers, body=b""):
        self.send_response(status)
        for name, value in headers.items():
            self.send_header(name, value)
        self.send_header("Content-Length", str(len(body)))
        self.send_header("Connection", "close")
        self.end_headers()
        try:
            self.wfile.write(body)
        except ConnectionError:
            pass  # who did not want this answer has hung up
        self.close_connection = True

    def do_GET(self):  # pylint: disable=invalid-name
        server = self.server
        server.log.append((self.path, dict(self.headers)))
        mode, data = server.mode, server.data
        path = self.path.partition("?")[0]
        if path.startswith("/old"):
            self.send(302, {"Location": server.target})
        elif mode == "silent":
            time.sleep(3)
        elif mode == "no answer":
            self.wfile.write(b"this is no answer of a server\r\n\r\n")
        elif mode in ("404", "403", "503"):
            self.send(int(mode), {})
        elif mode == "busy" and len(server.log) < 3:
            self.send(503, {})
        elif mode == "ignores ranges":
            self.send(200, {}, data)
        elif mode == "compresses":
            self.send(200, {"Content-Encoding": "gzip"}, gzip.compress(data))
        else:
            self.send_range(mode, data)

    def send_range(self, mode, data):
        first, last = map(int, re.fullmatch(r"bytes=(\d+)-(\d+)", self.headers["Range"]).groups())
        tag = '"two"' if mode == "changes" and len(self.server.log) > 1 else self.server.tag
        headers = {"ETag": tag} if tag else {"Last-Modified": self.server.date} if self.server.date else {}
        condition = self.headers["If-Range"]
        if condition and condition not in (tag, self.server.date):
            self.send(200, headers, data)
            return
        if first >= len(data):
            self.send(416, {"Content-Range": f"bytes */{len(data)}"})
            return
        body = data[first : last + 1]
        if mode == "sends less" and first:
            body = body[: len(body) // 2]
        shift = 1 if mode == "another part" and first else 0
        headers["Content-Range"] = f"bytes {first + shift}-{first + len(body) - 1}/{len(data)}"
        if mode == "no range":
            del headers["Content-Range"]
        if mode == "unknown size":
            headers["Content-Range"] = f"bytes {first}-{first + len(body) - 1}/*"
        if mode == "wrong size" and first:
            headers["Content-Range"] = f"bytes {first}-{first + len(body) - 1}/{2**63}"
        if mode == "sends more":
            body += b"more"
        if mode == "compresses parts":
            headers["Content-Encoding"] = "br"
        if mode == "breaks off" and first:
            body = body[: len(body) // 2]
        self.send(206, headers, body)


class QuietServer(http.server.ThreadingHTTPServer):
    """Says nothing of clients that hang up because they do not like the certificate."""

    daemon_threads = True

    def handle_error(self, request, client_address):
        if not isinstance(sys.exc_info()[1], (ssl.SSLError, ConnectionError)):
            super().handle_error(request, client_address)


class Server:
    """A server on the loopback address, while a block runs.

    Args:
        certificate: the paths of a certificate and its key, for https.
    """

    def __init__(self, data, mode="good", tag='"one"', date=None, name="file", certificate=None):
        self.http = QuietServer(("127.0.0.1", 0), Handler)
        self.http.data, self.http.mode, self.http.tag, self.http.date = data, mode, tag, date
        self.http.target = "/" + name
        self.http.log = []
        if certificate:
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
            context.load_cert_chain(*certificate)
            self.http.socket = context.wrap_socket(self.http.socket, server_side=True, do_handshake_on_connect=False)
        self.url = f"http{'s' if certificate else ''}://127.0.0.1:{self.http.server_address[1]}/{name}"

    def __enter__(self):
        threading.Thread(target=self.http.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True).start()
        return self

    def __exit__(self, *_):
        self.http.shutdown()
        self.http.server_close()
