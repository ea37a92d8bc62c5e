// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnWebFile.h"

#include "gtnFailure.h"
#include "gtnProgress.h"
#include "gtnText.h"

#include "gatunError.h"
#include "gatunVersion.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <new>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

namespace gtn
{
namespace
{
constexpr int Tries = 3;
constexpr std::chrono::milliseconds FirstPause{ 200 }; // before it is tried again
constexpr std::array<long, 5> Temporary{ 429, 500, 502, 503, 504 };

/** Seconds to wait for a server: as the environment says, or else 60. */
long FindTimeout()
{
  constexpr long usual = 60;
  constexpr long most = 86400;
  const char* const given = std::getenv("GTN_TIMEOUT");
  if (!given)
  {
    return usual;
  }
  long seconds = 0;
  const std::string_view text(given);
  const auto read = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || seconds < 1 ||
    seconds > most)
  {
    throw UsageError("GTN_TIMEOUT: must be a number of seconds from 1 to 86400");
  }
  return seconds;
}

/** Takes a prefix away; false if the text has another one. */
bool Skip(std::string_view& text, std::string_view prefix)
{
  const bool is = text.starts_with(prefix);
  text.remove_prefix(is ? prefix.size() : 0);
  return is;
}

std::optional<std::uint64_t> TakeNumber(std::string_view& text)
{
  std::uint64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc())
  {
    return std::nullopt;
  }
  text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
  return number;
}

/** An empty file has no range. */
struct NoRange
{
};

/** A part of a file as a server tells it. */
struct Part
{
  std::uint64_t First = 0;
  std::uint64_t Last = 0;
  std::uint64_t Size = 0;
};

/** Reads "bytes 0-99/1000". */
std::optional<Part> ReadContentRange(std::string_view text)
{
  if (!Skip(text, "bytes"))
  {
    return std::nullopt;
  }
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  const auto first = TakeNumber(text);
  const bool hasDash = Skip(text, "-");
  const auto last = TakeNumber(text);
  const bool hasSlash = Skip(text, "/");
  const auto size = TakeNumber(text);
  if (!first || !hasDash || !last || !hasSlash || !size || !text.empty())
  {
    return std::nullopt;
  }
  return Part{ *first, *last, *size };
}
}

//------------------------------------------------------------------------------
/** A connection for one request: one that is idle, or else another one. */
class WebFile::Lease
{
public:
  explicit Lease(const WebFile& file)
    : File(file)
  {
    {
      const std::lock_guard<std::mutex> lock(file.Guard);
      if (!file.Idle.empty())
      {
        this->Connection = std::move(file.Idle.back());
        file.Idle.pop_back();
        return;
      }
    }
    this->Connection = std::make_unique<WebConnection>(file.Address, file.Timeout);
  }
  ~Lease()
  {
    try
    {
      const std::lock_guard<std::mutex> lock(this->File.Guard);
      this->File.Idle.push_back(std::move(this->Connection));
    }
    catch (const std::bad_alloc&)
    {
      // It is closed.
    }
  }
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;

  WebConnection& operator*() const { return *this->Connection; }

private:
  const WebFile& File;
  std::unique_ptr<WebConnection> Connection;
};

//------------------------------------------------------------------------------
WebFile::WebFile(const std::string& address, std::uint64_t first)
  : Address(address)
  , Timeout(FindTimeout())
{
  auto answer = this->Request(0, first);
  this->First = std::move(answer.Body);
  this->Size = answer.Size;
  this->Known = std::move(answer.Of);
  this->IsOpen = true;
  if (this->First.size() != std::min(first, this->Size))
  {
    this->Fail("the server has sent " + std::to_string(this->First.size()) + " bytes in place of " +
      std::to_string(std::min(first, this->Size)));
  }
}

WebFile::~WebFile() = default;

//------------------------------------------------------------------------------
WebFile::Bytes WebFile::Get(std::uint64_t offset, std::uint64_t length) const
{
  auto bytes = this->Request(offset, length).Body;
  if (bytes.size() != length)
  {
    this->Fail("the server has sent " + std::to_string(bytes.size()) + " bytes in place of " +
      std::to_string(length));
  }
  return bytes;
}

//------------------------------------------------------------------------------
void WebFile::Fail(const std::string& problem) const
{
  throw gatun::Error(gatun::ErrorCode::CannotOpen, { .Path = this->Address, .What = problem });
}

//------------------------------------------------------------------------------
WebFile::Answer WebFile::Request(std::uint64_t offset, std::uint64_t length) const
{
  for (int number = 1;; ++number)
  {
    try
    {
      return this->Try(offset, length);
    }
    catch (const WebFailure& failure)
    {
      if (!failure.IsTemporary || number == Tries)
      {
        this->Fail(failure.what());
      }
    }
    std::this_thread::sleep_for(FirstPause * (1 << (number - 1)));
    if (IsInterrupted())
    {
      throw gatun::Error(gatun::ErrorCode::Aborted, "aborted");
    }
  }
}

//------------------------------------------------------------------------------
WebFile::Answer WebFile::Try(std::uint64_t offset, std::uint64_t length) const
{
  Answer answer;
  std::size_t expected = 0;
  WebRequest request;
  request.Fields = this->MakeFields(offset, length);
  request.Check = [&](const WebHead& head)
  { return expected = this->Check(head, offset, length, answer); };
  try
  {
    const Lease connection(*this);
    answer.Body = (*connection).Get(request);
  }
  catch (const NoRange&)
  {
    return answer;
  }
  if (answer.Body.size() != expected)
  {
    // As that of a connection that broke.
    throw WebFailure("the server has sent " + std::to_string(answer.Body.size()) +
        " bytes in place of " + std::to_string(expected),
      true);
  }
  return answer;
}

//------------------------------------------------------------------------------
std::vector<std::string> WebFile::MakeFields(std::uint64_t offset, std::uint64_t length) const
{
  std::vector<std::string> fields{ "Range: bytes=" + std::to_string(offset) + "-" +
      std::to_string(offset + length - 1),
    "Accept-Encoding: identity", // ranges of a compressed file are of no use
    std::string("User-Agent: gtn/") + gatun::PackageVersion() };
  // A weak tag must not be used so.
  const auto& [tag, date] = this->Known;
  const auto& condition = tag.empty() ? date : tag;
  if (!condition.empty() && !tag.starts_with("W/"))
  {
    fields.push_back("If-Range: " + condition);
  }
  return fields;
}

//------------------------------------------------------------------------------
/** Checks the head of an answer. Returns the size of its body. */
std::size_t WebFile::Check(
  const WebHead& head, std::uint64_t offset, std::uint64_t length, Answer& answer) const
{
  const auto status = head.Status;
  if (status == 416 && offset == 0)
  {
    throw NoRange();
  }
  if (status >= 300)
  {
    throw WebFailure(
      "the server says " + std::to_string(status) + (head.Reason.empty() ? "" : " " + head.Reason),
      std::find(Temporary.begin(), Temporary.end(), status) != Temporary.end());
  }
  answer.Of = { head.Get("etag"), head.Get("last-modified") };
  if (this->IsOpen && answer.Of != this->Known)
  {
    this->Fail("the file on the server has changed since it was opened");
  }
  const auto coding = LowerOf(head.Get("content-encoding"));
  if (!coding.empty() && coding != "identity")
  {
    this->Fail("the server compresses the file (" + coding + "), so that no part of it can be had");
  }
  if (status != 206)
  {
    this->Fail("the server does not answer range requests, by which parts of a file are fetched");
  }
  const auto part = ReadContentRange(head.Get("content-range"));
  if (!part)
  {
    this->Fail("the server does not tell which part of the file it sends, and its size");
  }
  if (this->IsOpen && part->Size != this->Size)
  {
    this->Fail("the file on the server has changed since it was opened");
  }
  if (part->First != offset || part->Last < part->First ||
    part->Last >= std::min(offset + length, part->Size))
  {
    this->Fail("the server sends another part of the file than it was asked for");
  }
  answer.Size = part->Size;
  return static_cast<std::size_t>(part->Last - part->First + 1);
}
}
