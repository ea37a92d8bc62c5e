// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnCurl_h
#define gtnCurl_h

// Requests to web servers by libcurl, which is loaded when the first one is made.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace gtn
{
/** The head of an answer. */
struct WebHead
{
  long Status = 0;
  std::string Reason;                        ///< such as "Not Found"; HTTP/2 has none
  std::map<std::string, std::string> Fields; ///< by names in lower case

  /** The value of a field, or an empty text. */
  std::string Get(const std::string& name) const;
};

struct WebRequest
{
  std::vector<std::string> Fields; ///< such as "Range: bytes=0-9"

  /** Called with the head, before any byte of the body is taken. What it throws ends the request.
   * Returns the number of bytes that the body may have. */
  std::function<std::size_t(const WebHead&)> Check;
};

/** No answer, or only a part of one. The text says why. */
class WebFailure : public std::runtime_error
{
public:
  WebFailure(const std::string& text, bool isTemporary)
    : std::runtime_error(text)
    , IsTemporary(isTemporary)
  {
  }

  const bool IsTemporary; ///< whether it is of use to try again
};

/** A connection to a server, which stays open for further requests. Not thread safe. */
class WebConnection
{
public:
  /** Throws Failure with the remedy if there is no libcurl. timeout: seconds to wait. */
  WebConnection(const std::string& address, long timeout);
  ~WebConnection();
  WebConnection(const WebConnection&) = delete;
  WebConnection& operator=(const WebConnection&) = delete;

  /** Makes a request; returns the body. Throws WebFailure, Error(Aborted) after Ctrl+C, and what
   * Check throws. Redirects are followed, but neither to other protocols nor from https to http. */
  std::vector<std::uint8_t> Get(const WebRequest& request);

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
