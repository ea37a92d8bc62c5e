// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBorder.h"

#include "gatunParallel.h"
#include "gatunVersion.h"

#include <cerrno>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

namespace gatun
{
namespace
{
/** The last failure of a thread, in memory that is there when there is no other. */
struct Failure
{
  char Text[2048] = "";
  std::uint64_t Offset = 0;
  std::uint64_t Length = 0;
  bool HasOffset = false;
  int SystemError = 0;
};

thread_local Failure LastFailure;

gatun_status Note(gatun_status status, const char* text) noexcept
{
  LastFailure = {};
  std::strncpy(LastFailure.Text, text, sizeof(LastFailure.Text) - 1);
  return status;
}

/** Bytes by the callbacks of a caller. */
class CallerSource final : public ByteSource
{
public:
  explicit CallerSource(const gatun_source& source)
    : Source(source)
    , Name(source.name ? source.name : "")
  {
  }
  ~CallerSource() override
  {
    if (this->Source.close)
    {
      this->Source.close(this->Source.user);
    }
  }
  CallerSource(const CallerSource&) = delete;
  CallerSource& operator=(const CallerSource&) = delete;

  std::uint64_t GetSize() const override { return this->Source.bytes; }

  int ReadAt(std::uint64_t offset, std::span<std::uint8_t>& bytes) const override
  {
    const auto all = this->Source.bytes;
    const auto rest = all - std::min(offset, all);
    const auto length = static_cast<std::size_t>(std::min<std::uint64_t>(rest, bytes.size()));
    if (length > 0)
    {
      if (const int error = this->Source.read(this->Source.user, offset, bytes.data(), length))
      {
        return error == GATUN_SOURCE_NOT_HERE ? NotHere : error;
      }
    }
    bytes = bytes.subspan(length);
    return 0;
  }

  bool IsRemote() const override { return this->Source.fetch != nullptr; }

  void Fetch(const std::vector<ByteRange>& ranges) const override
  {
    std::vector<gatun_range> all;
    for (const auto& range : ranges)
    {
      all.push_back({ range.Offset, range.Length });
    }
    const int error =
      all.empty() ? 0 : this->Source.fetch(this->Source.user, all.data(), all.size());
    if (error != 0 && error != GATUN_SOURCE_NOT_HERE) // read tells what is not here
    {
      throw Error(
        ErrorCode::CannotOpen, { .Path = this->Name, .What = "cannot read", .SystemError = error });
    }
  }

private:
  const gatun_source Source;
  const std::string Name;
};
}

//------------------------------------------------------------------------------
gatun_status NoteFailure() noexcept
{
  try
  {
    throw;
  }
  catch (const Error& error)
  {
    const auto status = Note(static_cast<gatun_status>(error.Code), error.what());
    LastFailure.HasOffset = error.Offset.has_value();
    LastFailure.Offset = error.Offset.value_or(0);
    LastFailure.Length = error.Length;
    LastFailure.SystemError = error.SystemError;
    return status;
  }
  catch (const std::bad_alloc&)
  {
    return Note(GATUN_NO_MEMORY, "out of memory");
  }
  catch (const std::length_error&)
  {
    return Note(GATUN_NO_MEMORY, "out of memory");
  }
  catch (const std::exception& error)
  {
    return Note(GATUN_INTERNAL, error.what());
  }
  catch (...)
  {
    return Note(GATUN_INTERNAL, "it failed for an unknown reason");
  }
}

//------------------------------------------------------------------------------
std::size_t Product(std::uint64_t a, std::uint64_t b)
{
  if (b != 0 && a > std::numeric_limits<std::size_t>::max() / b)
  {
    throw std::bad_array_new_length();
  }
  return static_cast<std::size_t>(a * b);
}

//------------------------------------------------------------------------------
void GiveText(const std::string& text, char* to, std::size_t capacity, std::size_t* length)
{
  *length = text.size() + 1;
  if (to && capacity >= *length)
  {
    std::memcpy(to, text.c_str(), *length);
  }
}

//------------------------------------------------------------------------------
void GiveRanges(std::vector<ByteRange> ranges, const std::vector<ByteRange>& missing,
  std::uint64_t gap, gatun_range* to, std::size_t capacity, std::size_t* count)
{
  const auto joined = JoinRanges(missing.empty() ? std::move(ranges) : missing, gap);
  *count = joined.size();
  for (std::size_t i = 0; to && i < std::min(capacity, joined.size()); ++i)
  {
    to[i] = { joined[i].Offset, joined[i].Length };
  }
  if (!missing.empty())
  {
    throw Error(ErrorCode::NotHere,
      ErrorDetails{ .What = "tables that say what is needed are not here yet",
        .Offset = joined.front().Offset,
        .Length = joined.front().Length });
  }
}

//------------------------------------------------------------------------------
std::function<bool(double)> WrapProgress(gatun_progress progress, void* user)
{
  if (!progress)
  {
    return {};
  }
  return [progress, user](double fraction) { return progress(fraction, user) != 0; };
}

//------------------------------------------------------------------------------
std::shared_ptr<const ByteSource> WrapSource(const gatun_source* source, std::string& name)
{
  const auto own = Take(source);
  Need(own.read != nullptr, "a source needs the function read");
  name = own.name ? own.name : "";
  return std::make_shared<const CallerSource>(own);
}

//------------------------------------------------------------------------------
void GiveBounds(const Bounds& from, double (&to)[6])
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    to[2 * axis] = from[axis].Min;
    to[2 * axis + 1] = from[axis].Max;
  }
}

//------------------------------------------------------------------------------
ScalarType TakeType(gatun_type type)
{
  Need(type >= GATUN_INT8 && type <= GATUN_FLOAT64, "there is no such type of numbers");
  return static_cast<ScalarType>(type);
}

//------------------------------------------------------------------------------
TextList::TextList(const std::vector<std::string>& texts)
{
  for (const auto& text : texts)
  {
    this->List.push_back(text.c_str());
  }
}

//------------------------------------------------------------------------------
KeyList::KeyList(const std::vector<ArrayKey>& keys)
{
  this->Texts.reserve(keys.size());
  for (const auto& key : keys)
  {
    gatun_key own{};
    own.size = sizeof(own);
    own.location = key.Location.c_str();
    own.name = key.Name.c_str();
    own.kind = static_cast<std::uint32_t>(key.Kind);
    own.count =
      static_cast<std::uint32_t>(IsOfTexts(key.Kind) ? key.Texts.size() : key.Numbers.size());
    own.numbers = IsOfTexts(key.Kind) ? nullptr : key.Numbers.data();
    own.texts = this->Texts.emplace_back(key.Texts).Get();
    this->List.push_back(own);
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> TakeTexts(const char* const* texts, std::uint64_t count)
{
  std::vector<std::string> own;
  for (std::uint64_t i = 0; texts && i < count; ++i)
  {
    own.emplace_back(texts[i] ? texts[i] : "");
  }
  return own;
}

//------------------------------------------------------------------------------
std::vector<ArrayKey> TakeKeys(const gatun_key* keys, std::uint32_t count)
{
  std::vector<ArrayKey> own;
  for (std::uint32_t i = 0; keys && i < count; ++i)
  {
    const auto key = TakeElement(keys, i);
    NeedPointers(key.location, key.name);
    Need(key.kind >= static_cast<std::uint32_t>(KeyKind::Integer) &&
        key.kind <= static_cast<std::uint32_t>(KeyKind::Quadrature),
      "there is no such kind of key");
    ArrayKey made{ key.location, key.name, static_cast<KeyKind>(key.kind), {}, {} };
    if (IsOfTexts(made.Kind))
    {
      Need(key.texts || key.count == 0, "a key of texts has none");
      made.Texts = TakeTexts(key.texts, key.count);
    }
    else
    {
      Need(key.numbers || key.count == 0, "a key of numbers has none");
      made.Numbers.assign(key.numbers, key.numbers + key.count);
    }
    own.push_back(std::move(made));
  }
  return own;
}

//------------------------------------------------------------------------------
ArrayDescription TakeArray(const gatun_array& array)
{
  ArrayDescription own;
  Need(array.name != nullptr, "an array has no name");
  Need(array.components > 0, "an array has no components");
  own.Name = array.name;
  own.Where = array.is_cell ? Association::Cell : Association::Point;
  own.Type = TakeType(array.type);
  own.Components = array.components;
  own.VTKType = array.vtk_type;
  own.AttributeRoles = array.roles;
  own.ComponentNames = TakeTexts(array.component_names, array.components);
  own.Keys = TakeKeys(array.keys, array.key_count);
  return own;
}
}

//------------------------------------------------------------------------------
using gatun::LastFailure;

uint32_t gatun_api_version(void)
{
  return GATUN_API_VERSION;
}

const char* gatun_version(void)
{
  return gatun::PackageVersion();
}

const char* gatun_error(void)
{
  return LastFailure.Text;
}

int gatun_error_place(uint64_t* offset, uint64_t* length, int* system_error)
{
  if (offset)
  {
    *offset = LastFailure.Offset;
  }
  if (length)
  {
    *length = LastFailure.Length;
  }
  if (system_error)
  {
    *system_error = LastFailure.SystemError;
  }
  return LastFailure.HasOffset ? 1 : 0;
}

void gatun_set_threads(int threads)
{
  gatun::SetNumberOfThreads(threads);
}

int gatun_threads(void)
{
  return gatun::GetNumberOfThreads();
}
