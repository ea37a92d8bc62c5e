// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnWebFile_h
#define gtnWebFile_h

#include "gtnCurl.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace gtn
{
/**
 * A file on a web server that answers range requests, as RFC 9110 has them.
 *
 * Thread safe: each thread has a connection of its own. Safe on hostile input: memory is bounded by
 * what is asked for, and a server that does not answer is given up.
 */
class WebFile
{
public:
  using Bytes = std::vector<std::uint8_t>;

  /** Fetches the first bytes; a file that has fewer is fetched whole. Throws as Get, and Failure
   * without libcurl. */
  WebFile(const std::string& address, std::uint64_t first);
  ~WebFile();
  WebFile(const WebFile&) = delete;
  WebFile& operator=(const WebFile&) = delete;

  std::uint64_t GetSize() const { return this->Size; }
  const Bytes& GetFirst() const { return this->First; }

  /** Fetches a part, which must be inside the file. Failures that may pass are tried again. Throws
   * Error(CannotOpen) if it cannot be had or the file has changed meanwhile. */
  Bytes Get(std::uint64_t offset, std::uint64_t length) const;

private:
  /** What tells one version of the file from another. */
  struct Version
  {
    std::string Tag;
    std::string Date;
    bool operator==(const Version&) const = default;
  };

  struct Answer
  {
    Bytes Body;
    std::uint64_t Size = 0; // of the file
    Version Of;
  };

  Answer Request(std::uint64_t offset, std::uint64_t length) const;
  Answer Try(std::uint64_t offset, std::uint64_t length) const;
  std::size_t Check(
    const WebHead& head, std::uint64_t offset, std::uint64_t length, Answer& answer) const;
  std::vector<std::string> MakeFields(std::uint64_t offset, std::uint64_t length) const;
  [[noreturn]] void Fail(const std::string& problem) const;

  const std::string Address;
  const long Timeout;
  bool IsOpen = false; // whether what follows is known
  std::uint64_t Size = 0;
  Version Known;
  Bytes First;

  class Lease;
  mutable std::mutex Guard;
  mutable std::vector<std::unique_ptr<WebConnection>> Idle;
};
}

#endif
