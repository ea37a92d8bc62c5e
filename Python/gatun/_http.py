# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files on web servers, of which only the parts that are needed are fetched."""

from __future__ import annotations

import collections
import concurrent.futures
import errno
import http.client
import re
import socket
import ssl
import threading
import time
import urllib.error
import urllib.parse
import urllib.request
from collections.abc import Iterable, Mapping

from ._exceptions import Error

_BLOCK = 64 * 1024
_MOST_BLOCKS = 128  # in one request
_CONNECTIONS = 4
_TRIES = 3
_FIRST_PAUSE = 0.2  # seconds, before it is tried again
_TEMPORARY = (429, 500, 502, 503, 504)
_ERRNOS = {401: errno.EACCES, 403: errno.EACCES, 404: errno.ENOENT, 410: errno.ENOENT}


class _Redirects(urllib.request.HTTPRedirectHandler):
    """Follows redirects, but neither to other protocols nor from https to http."""

    def redirect_request(self, req, fp, code, msg, headers, newurl):  # pylint: disable=too-many-arguments
        """The request of the address that a server names."""
        schemes = ("https",) if req.full_url.lower().startswith("https:") else ("http", "https")
        if urllib.parse.urlsplit(newurl).scheme.lower() not in schemes:
            raise Error(f"{req.full_url}: the server redirects to {newurl}, which is not safe")
        return super().redirect_request(req, fp, code, msg, headers, newurl)


class HttpSource:
    """A file on a web server, for ``gatun.open``.

    The server has to answer range requests. Parts that have been fetched are kept, up to a limit.

    Args:
        url: the address, which begins with ``http://`` or ``https://``.
        headers: of each request, such as ``{"Authorization": "Bearer ..."}``.
        timeout: seconds to wait for the server.
        cache_bytes: the largest amount of fetched bytes to keep.

    Attributes:
        size: of the file in bytes.
        name: the address.
        requests: the number of requests so far.
        bytes_fetched: the number of bytes that they have brought.

    Raises:
        OSError: the server cannot be reached, or has no such file, as FileNotFoundError.
        Error: the server does not send parts of files.
    """

    size: int
    name: str
    requests: int
    bytes_fetched: int

    def __init__(
        self,
        url: str,
        *,
        headers: Mapping[str, str] | None = None,
        timeout: float = 60.0,
        cache_bytes: int = 64 << 20,
    ) -> None:
        self.name = url
        self.requests = 0
        self.bytes_fetched = 0
        self._url = url
        self._headers = dict(headers or {})
        self._timeout = timeout
        self._most_kept = max(cache_bytes // _BLOCK, 1)
        self._opener = urllib.request.build_opener(_Redirects())
        self._lock = threading.Lock()
        self._kept = collections.OrderedDict()  # blocks by number, those used last at the end
        self._pending = {}  # futures of blocks that are being fetched
        self._version = None
        self.size = 0
        first, self.size, self._version = self._request(0, _BLOCK)
        if len(first) != min(_BLOCK, self.size):
            raise self._fail(f"the server has sent {len(first)} bytes in place of {min(_BLOCK, self.size)}")
        self._kept[0] = first

    def read(self, offset: int, length: int) -> bytes:
        """Returns bytes of the file.

        Args:
            offset: of the first one.
            length: the number of bytes.
        """
        end = min(offset + length, self.size)
        if offset >= end:
            return b""
        numbers = range(offset // _BLOCK, (end - 1) // _BLOCK + 1)
        blocks = self._obtain(numbers)
        data = b"".join(blocks[number] for number in numbers)
        start = offset - numbers[0] * _BLOCK
        return data[start : start + end - offset]

    def fetch(self, ranges: Iterable[tuple[int, int]]) -> None:
        """Fetches parts of the file that will be read soon, with few requests.

        Args:
            ranges: pairs of offset and length.
        """
        numbers = set()
        before = None  # the end of the range before
        for offset, length in sorted(ranges):
            end = min(offset + length, self.size)
            if length > 0 and offset < end:
                # A small gap is fetched rather than to make another request.
                start = before if before is not None and before < offset <= before + _BLOCK else offset
                numbers.update(range(start // _BLOCK, (end - 1) // _BLOCK + 1))
                before = end
        # More would push each other out; read fetches the rest.
        self._obtain(sorted(numbers)[: self._most_kept])

    def _obtain(self, numbers):
        """Blocks by number, those that have to be fetched included."""
        found, waiting, own = {}, {}, []
        with self._lock:
            for number in numbers:
                if number in self._kept:
                    self._kept.move_to_end(number)
                    found[number] = self._kept[number]
                elif number in self._pending:
                    waiting[number] = self._pending[number]
                else:
                    waiting[number] = self._pending[number] = concurrent.futures.Future()
                    own.append(number)
        self._fetch_runs(_join(own))
        for number, future in waiting.items():
            found[number] = future.result()
        return found

    def _fetch_runs(self, runs):
        if len(runs) < 2:
            for run in runs:
                self._fetch_run(run)
            return
        with concurrent.futures.ThreadPoolExecutor(min(len(runs), _CONNECTIONS)) as pool:
            list(pool.map(self._fetch_run, runs))

    def _fetch_run(self, run):
        """Fetches blocks in a row. A failure is that of their futures."""
        first, last = run
        offset = first * _BLOCK
        length = min((last + 1) * _BLOCK, self.size) - offset
        failure = None
        try:
            data, _, _ = self._request(offset, length)
            if len(data) != length:
                raise self._fail(f"the server has sent {len(data)} bytes in place of {length}")
        except BaseException as error:  # pylint: disable=broad-except
            failure = error
        with self._lock:
            for number in range(first, last + 1):
                future = self._pending.pop(number)
                if failure is not None:
                    future.set_exception(failure)
                    continue
                start = (number - first) * _BLOCK
                block = data[start : start + _BLOCK]
                self._kept[number] = block
                future.set_result(block)
            while len(self._kept) > self._most_kept:
                self._kept.popitem(last=False)

    # Requests

    def _request(self, offset, length):
        """The bytes of a range, the size of the file, and what tells its version."""
        for number in range(_TRIES):
            is_last = number == _TRIES - 1
            try:
                return self._try_request(offset, length)
            except urllib.error.HTTPError as error:
                with error:
                    if error.code == 416 and offset == 0:
                        return b"", 0, None  # an empty file has no range
                    if is_last or error.code not in _TEMPORARY:
                        raise self._explain(error) from None
            except (http.client.HTTPException, socket.timeout, urllib.error.URLError, ConnectionError) as error:
                if is_last or _is_final(error):
                    raise self._explain(error) from None
            time.sleep(_FIRST_PAUSE * 2**number)
        raise AssertionError("not reached")

    def _try_request(self, offset, length):
        headers = {
            **self._headers,
            "Range": f"bytes={offset}-{offset + length - 1}",
            # Ranges of a compressed file are of no use.
            "Accept-Encoding": "identity",
        }
        if self._version is not None:
            tag, date = self._version
            # A weak tag must not be used so.
            condition = tag if tag and not tag.startswith("W/") else date if not tag else None
            if condition:
                headers["If-Range"] = condition
        with self._lock:
            self.requests += 1
        request = urllib.request.Request(self._url, headers=headers)
        with self._opener.open(request, timeout=self._timeout) as response:
            size, expected = self._check(response, offset, length)
            data = response.read(length + 1)
            version = (response.headers.get("ETag"), response.headers.get("Last-Modified"))
        with self._lock:
            self.bytes_fetched += len(data)
        if len(data) != expected:
            # As that of a connection that broke.
            raise ConnectionError(f"the server has sent {len(data)} bytes in place of {expected}")
        return data, size, version

    def _check(self, response, offset, length):
        """Checks the head of an answer. Returns the size of the file, and that of the part."""
        version = (response.headers.get("ETag"), response.headers.get("Last-Modified"))
        coding = response.headers.get("Content-Encoding", "identity").strip().lower()
        if self._version is not None and version != self._version:
            raise self._fail("the file on the server has changed since it was opened")
        if coding not in ("", "identity"):
            raise self._fail(f"the server compresses the file ({coding}), so that no part of it can be had")
        if response.status != 206:
            raise self._fail("the server does not answer range requests, by which parts of a file are fetched")
        found = re.fullmatch(r"bytes\s+(\d+)-(\d+)/(\d+)", response.headers.get("Content-Range", "").strip())
        if not found:
            raise self._fail("the server does not tell which part of the file it sends, and its size")
        start, last, size = map(int, found.groups())
        if self._version is not None and size != self.size:
            raise self._fail("the file on the server has changed since it was opened")
        if start != offset or last >= min(offset + length, size):
            raise self._fail("the server sends another part of the file than it was asked for")
        return size, last - start + 1

    def _fail(self, problem):
        return Error(f"{self.name}: {problem}")

    def _explain(self, error):
        """An exception of this package for one of urllib."""
        if isinstance(error, urllib.error.HTTPError):
            number = _ERRNOS.get(error.code, errno.EIO)
            return OSError(number, f"the server says {error.code} {error.reason}", self.name)
        if isinstance(error, urllib.error.URLError):
            error = error.reason
        if isinstance(error, socket.timeout):
            return TimeoutError(errno.ETIMEDOUT, "the server does not answer in time", self.name)
        if isinstance(error, ssl.SSLError):  # its numbers are not those of the system
            return OSError(errno.EIO, _describe_failure(error), self.name)
        number = getattr(error, "errno", None)
        text = getattr(error, "strerror", None) or str(error) or type(error).__name__
        return OSError(number if isinstance(number, int) and number > 0 else errno.EIO, text, self.name)


def _join(numbers):
    """Ascending numbers as pairs of the first and last one of each run."""
    runs = []
    for number in numbers:
        if runs and number == runs[-1][1] + 1 and number - runs[-1][0] < _MOST_BLOCKS:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    return runs


def _describe_failure(error):
    """Why there is no secure connection, and the remedy."""
    if not isinstance(error, ssl.SSLCertVerificationError):
        return f"there is no secure connection: {error.reason or error}"
    is_other_host = "mismatch" in error.verify_message
    remedy = (
        "use a name that it has"
        if is_other_host
        else "if its issuer can be trusted, let the environment variable SSL_CERT_FILE name a file with the "
        "issuer's certificate"
    )
    return f"the certificate of the server is not valid: {error.verify_message.rstrip('.')}; {remedy}"


def _is_final(error):
    """Whether it is of no use to try again, as for a host that does not exist."""
    reason = getattr(error, "reason", error)
    kinds = (socket.gaierror, ConnectionRefusedError, ssl.SSLCertVerificationError, str)
    return isinstance(reason, kinds) and not isinstance(
        error, http.client.HTTPException
    )
