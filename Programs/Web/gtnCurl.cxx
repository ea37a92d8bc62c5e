// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnCurl.h"

#include "gtnFailure.h"
#include "gtnProgress.h"
#include "gtnText.h"

#include "gatunError.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <initializer_list>
#include <new>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace gtn
{
namespace
{
// What is used of the interface of libcurl.so.4. Its numbers never change, so that neither building
// nor installing gtn needs libcurl.
enum CurlOption : int
{
  OptionProtocols = 181,
  OptionRedirectProtocols = 182,
  OptionLowSpeedLimit = 19,
  OptionLowSpeedTime = 20,
  OptionNoProgress = 43,
  OptionFollow = 52,
  OptionMostRedirects = 68,
  OptionConnectTimeout = 78,
  OptionNoSignal = 99,
  OptionWriteData = 10001,
  OptionAddress = 10002,
  OptionErrorBuffer = 10010,
  OptionFields = 10023,
  OptionHeaderData = 10029,
  OptionWriteFunction = 20011,
  OptionHeaderFunction = 20079,
  OptionProgressFunction = 20219
};
enum CurlCode : int
{
  CodeUnsupportedProtocol = 1,
  CodeBadAddress = 3,
  CodeNoProxy = 5,
  CodeNoHost = 6,
  CodeCannotConnect = 7,
  CodeWriteError = 23,
  CodeTimeout = 28,
  CodeAborted = 42,
  CodeTooManyRedirects = 47,
  CodeBadCertificate = 60,
  CodeNoCertificates = 77 // of issuers that the system trusts
};
constexpr long ProtocolHttp = 1;
constexpr long ProtocolHttps = 2;
constexpr long CurlGlobalAll = 3;
constexpr std::size_t ErrorSize = 256;

struct FieldList; // of libcurl

/** The functions of libcurl. */
class Curl
{
public:
  /** Loads the library at the first call. Throws Failure for the address. */
  static const Curl& Load(const std::string& address);

  void* (*Begin)() = nullptr;
  void (*End)(void*) = nullptr;
  int (*Set)(void*, int, ...) = nullptr;
  int (*Run)(void*) = nullptr;
  const char* (*Describe)(int) = nullptr;
  FieldList* (*Append)(FieldList*, const char*) = nullptr;
  void (*Free)(FieldList*) = nullptr;

private:
  explicit Curl(const std::string& address);
};

template <typename Function>
bool Find(void* library, const char* name, Function& function)
{
  function = reinterpret_cast<Function>(::dlsym(library, name));
  return function != nullptr;
}

Curl::Curl(const std::string& address)
{
  void* library = nullptr;
  for (const char* const name : { "libcurl.so.4", "libcurl-gnutls.so.4" })
  {
    library = library ? library : ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
  }
  if (!library)
  {
    throw Failure(address,
      "gtn reads files on web servers by libcurl.so.4, which is not installed; its package is "
      "called libcurl4 or libcurl");
  }
  int (*start)(long) = nullptr;
  if (!Find(library, "curl_global_init", start) || !Find(library, "curl_easy_init", this->Begin) ||
    !Find(library, "curl_easy_cleanup", this->End) ||
    !Find(library, "curl_easy_setopt", this->Set) ||
    !Find(library, "curl_easy_perform", this->Run) ||
    !Find(library, "curl_easy_strerror", this->Describe) ||
    !Find(library, "curl_slist_append", this->Append) ||
    !Find(library, "curl_slist_free_all", this->Free) || start(CurlGlobalAll) != 0)
  {
    throw Failure(address, "libcurl.so.4 is there, but cannot be used; install it anew");
  }
}

const Curl& Curl::Load(const std::string& address)
{
  static const Curl curl(address);
  return curl;
}

std::string_view Trim(std::string_view text)
{
  constexpr std::string_view blanks = " \t\r\n";
  const auto begin = text.find_first_not_of(blanks);
  return begin == text.npos ? std::string_view()
                            : text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

/** A text of a server for a message: not endless. */
std::string Shorten(const std::string& text)
{
  constexpr std::size_t most = 300;
  return text.size() <= most ? text : text.substr(0, most) + "...";
}
}

//------------------------------------------------------------------------------
std::string WebHead::Get(const std::string& name) const
{
  const auto found = this->Fields.find(name);
  return found == this->Fields.end() ? std::string() : found->second;
}

//------------------------------------------------------------------------------
class WebConnection::Internals
{
public:
  Internals(const std::string& address, long timeout);
  ~Internals() { this->Library.End(this->Handle); }
  Internals(const Internals&) = delete;
  Internals& operator=(const Internals&) = delete;

  std::vector<std::uint8_t> Get(const WebRequest& request);

private:
  /** The callbacks of libcurl. They keep what is thrown, because no exception may pass it. */
  static std::size_t TakeField(const char* text, std::size_t one, std::size_t size, void* self);
  static std::size_t TakeBody(const char* bytes, std::size_t one, std::size_t size, void* self);
  static int MayStop(void*, std::int64_t, std::int64_t, std::int64_t, std::int64_t)
  {
    return IsInterrupted() ? 1 : 0;
  }

  void AddField(std::string_view line);
  bool AddBody(std::span<const std::uint8_t> bytes);
  void CheckHead();
  [[noreturn]] void Fail(int code) const;

  const std::string Address;
  const Curl& Library;
  void* const Handle;
  std::array<char, ErrorSize> Message{};
  const WebRequest* Request = nullptr;
  WebHead Head;
  std::string Target; // of the last redirect
  std::optional<std::size_t> Most;
  std::vector<std::uint8_t> Body;
  std::exception_ptr Thrown;
};

//------------------------------------------------------------------------------
WebConnection::Internals::Internals(const std::string& address, long timeout)
  : Address(address)
  , Library(Curl::Load(address))
  , Handle(Library.Begin())
{
  if (!this->Handle)
  {
    throw std::bad_alloc();
  }
  const auto set = [this](CurlOption option, auto value)
  { this->Library.Set(this->Handle, option, value); };
  constexpr long mostRedirects = 10;
  constexpr long leastSpeed = 1000; // bytes a second; what is slower does not end
  const bool isSecure = LowerOf(address).starts_with("https:");
  set(OptionAddress, address.c_str());
  set(OptionProtocols, ProtocolHttp | ProtocolHttps);
  set(OptionRedirectProtocols, isSecure ? ProtocolHttps : ProtocolHttp | ProtocolHttps);
  set(OptionFollow, 1L);
  set(OptionMostRedirects, mostRedirects);
  set(OptionConnectTimeout, timeout);
  set(OptionLowSpeedLimit, leastSpeed);
  set(OptionLowSpeedTime, timeout);
  set(OptionNoSignal, 1L);
  set(OptionErrorBuffer, this->Message.data());
  set(OptionHeaderFunction, &TakeField);
  set(OptionHeaderData, static_cast<void*>(this));
  set(OptionWriteFunction, &TakeBody);
  set(OptionWriteData, static_cast<void*>(this));
  set(OptionProgressFunction, &MayStop);
  set(OptionNoProgress, 0L);
}

//------------------------------------------------------------------------------
std::size_t WebConnection::Internals::TakeField(
  const char* text, std::size_t one, std::size_t size, void* self)
{
  auto& own = *static_cast<Internals*>(self);
  try
  {
    own.AddField({ text, one * size });
    return one * size;
  }
  catch (...)
  {
    own.Thrown = std::current_exception();
    return 0;
  }
}

//------------------------------------------------------------------------------
std::size_t WebConnection::Internals::TakeBody(
  const char* bytes, std::size_t one, std::size_t size, void* self)
{
  auto& own = *static_cast<Internals*>(self);
  try
  {
    const bool isAll = own.AddBody({ reinterpret_cast<const std::uint8_t*>(bytes), one * size });
    return isAll ? one * size : 0;
  }
  catch (...)
  {
    own.Thrown = std::current_exception();
    return 0;
  }
}

//------------------------------------------------------------------------------
void WebConnection::Internals::AddField(std::string_view line)
{
  if (line.starts_with("HTTP/"))
  {
    // Of the next answer, after a redirect: "HTTP/1.1 206 Partial Content".
    this->Head = {};
    const auto blank = line.find(' ');
    const auto rest = blank == line.npos ? std::string_view() : line.substr(blank + 1);
    this->Head.Status = std::strtol(std::string(rest).c_str(), nullptr, 10);
    const auto second = rest.find(' ');
    this->Head.Reason = second == rest.npos ? std::string() : Trim(rest.substr(second));
    return;
  }
  const auto colon = line.find(':');
  if (colon == line.npos)
  {
    return;
  }
  const auto name = LowerOf(std::string(Trim(line.substr(0, colon))));
  const std::string value(Trim(line.substr(colon + 1)));
  if (name == "location")
  {
    this->Target = value;
  }
  this->Head.Fields[name] = value;
}

//------------------------------------------------------------------------------
void WebConnection::Internals::CheckHead()
{
  if (!this->Most)
  {
    this->Most = this->Request->Check(this->Head);
    this->Body.reserve(*this->Most);
  }
}

//------------------------------------------------------------------------------
/** Returns whether all was taken. */
bool WebConnection::Internals::AddBody(std::span<const std::uint8_t> bytes)
{
  this->CheckHead();
  const auto taken = bytes.first(std::min(bytes.size(), *this->Most - this->Body.size()));
  this->Body.insert(this->Body.end(), taken.begin(), taken.end());
  return taken.size() == bytes.size();
}

//------------------------------------------------------------------------------
void WebConnection::Internals::Fail(int code) const
{
  const std::string message =
    this->Message[0] ? this->Message.data() : this->Library.Describe(code);
  switch (code)
  {
    case CodeAborted:
      throw gatun::Error(gatun::ErrorCode::Aborted, "aborted");
    case CodeTimeout:
      throw WebFailure("the server does not answer in time", true);
    case CodeTooManyRedirects:
      throw WebFailure("the server redirects without end", false);
    case CodeUnsupportedProtocol:
      throw WebFailure(this->Target.empty()
          ? message
          : "the server redirects to " + Shorten(this->Target) + ", which is not safe",
        false);
    case CodeBadCertificate:
      throw WebFailure(message +
          "; the certificate must be for this host, and by an issuer that the system trusts",
        false);
    case CodeBadAddress:
    case CodeNoProxy:
    case CodeNoHost:
    case CodeCannotConnect:
    case CodeNoCertificates:
      throw WebFailure(message, false);
    default:
      throw WebFailure(message, true);
  }
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> WebConnection::Internals::Get(const WebRequest& request)
{
  this->Request = &request;
  this->Head = {};
  this->Target.clear();
  this->Most.reset();
  this->Body.clear();
  this->Thrown = nullptr;
  this->Message[0] = '\0';
  FieldList* fields = nullptr;
  for (const auto& field : request.Fields)
  {
    fields = this->Library.Append(fields, field.c_str());
  }
  this->Library.Set(this->Handle, OptionFields, fields);
  const int code = this->Library.Run(this->Handle);
  this->Library.Set(this->Handle, OptionFields, static_cast<FieldList*>(nullptr));
  this->Library.Free(fields);
  if (this->Thrown)
  {
    std::rethrow_exception(this->Thrown);
  }
  if (code == CodeWriteError && this->Most)
  {
    throw WebFailure(
      "the server has sent more than " + std::to_string(*this->Most) + " bytes", true);
  }
  if (code != 0)
  {
    this->Fail(code);
  }
  this->CheckHead(); // there may be no body
  return std::move(this->Body);
}

//------------------------------------------------------------------------------
WebConnection::WebConnection(const std::string& address, long timeout)
  : Self(std::make_unique<Internals>(address, timeout))
{
}

WebConnection::~WebConnection() = default;

//------------------------------------------------------------------------------
std::vector<std::uint8_t> WebConnection::Get(const WebRequest& request)
{
  return this->Self->Get(request);
}
}
