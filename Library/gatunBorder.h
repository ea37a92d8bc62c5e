// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBorder_h
#define gatunBorder_h

// The border between C and C++: errors, structures, buffers.

#include "gatun.h"
#include "gatunByteSource.h"
#include "gatunError.h"
#include "gatunTypes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace gatun
{
/** Notes the exception that is being handled for gatun_error, and returns its status. */
gatun_status NoteFailure() noexcept;

/** Runs the body of a function of the interface. */
template <typename Work>
gatun_status Guard(Work&& work) noexcept
{
  try
  {
    work();
    return GATUN_OK;
  }
  catch (...)
  {
    return NoteFailure();
  }
}

/** Throws Error(InvalidInput) with a text unless a condition holds. */
inline void Need(bool holds, const char* problem)
{
  if (!holds)
  {
    ThrowInvalid(problem);
  }
}

/** Throws if a pointer is null. */
template <typename... Pointers>
void NeedPointers(const Pointers*... pointers)
{
  Need((... && (pointers != nullptr)), "a pointer that is needed is null");
}

/** The members of a structure of the caller that the caller knows; the others are 0. Null: all are
 * 0.
 */
template <typename T>
T Take(const T* from)
{
  T own{};
  if (from)
  {
    Need(from->size >= sizeof(std::size_t) && from->size <= 4096,
      "a structure has no size; begin with GATUN_INIT");
    std::memcpy(&own, from, std::min(from->size, sizeof(T)));
  }
  own.size = sizeof(T);
  return own;
}

/** Sets the members of a structure of the caller that the caller knows. */
template <typename T>
void Give(T own, T* to)
{
  Need(to->size >= sizeof(std::size_t) && to->size <= 4096,
    "a structure has no size; begin with GATUN_INIT");
  own.size = to->size;
  std::memcpy(static_cast<void*>(to), &own, std::min(own.size, sizeof(T)));
}

/** Element i of an array of structures, which have the size of the first one each. */
template <typename T>
T TakeElement(const T* first, std::size_t i)
{
  Need(first->size >= sizeof(std::size_t) && first->size <= 4096,
    "a structure has no size; begin with GATUN_INIT");
  return Take(reinterpret_cast<const T*>(reinterpret_cast<const char*>(first) + i * first->size));
}

/** a times b. Throws std::bad_alloc if that is more than memory can have. */
std::size_t Product(std::uint64_t a, std::uint64_t b);

/** The memory of a buffer, null if it is left out. Throws if it has fewer bytes than are needed. */
template <typename T = void>
T* TakeBuffer(const gatun_buffer& buffer, std::uint64_t bytes, const std::string& what)
{
  if (buffer.data && buffer.bytes < bytes)
  {
    ThrowInvalid("the buffer of " + what + " has " + std::to_string(buffer.bytes) +
      " bytes, and needs " + std::to_string(bytes));
  }
  return static_cast<T*>(buffer.data);
}

/** Copies a text with its end if there is room for it, and tells its size. */
void GiveText(const std::string& text, char* to, std::size_t capacity, std::size_t* length);

/** Writes the ranges of a plan, or of its missing tables. Throws Error(NotHere) for these. */
void GiveRanges(std::vector<ByteRange> ranges, const std::vector<ByteRange>& missing,
  std::uint64_t gap, gatun_range* to, std::size_t capacity, std::size_t* count);

/** A callback of C as one of the core. */
std::function<bool(double)> WrapProgress(gatun_progress progress, void* user);

/** The bytes of a caller, and the name of the file. */
std::shared_ptr<const ByteSource> WrapSource(const gatun_source* source, std::string& name);

void GiveBounds(const Bounds& from, double (&to)[6]);

/** Throws unless it is a type of numbers. */
ScalarType TakeType(gatun_type type);

/** The texts of the library in the form of C. It has to be kept, and so have the texts. */
class TextList
{
public:
  explicit TextList(const std::vector<std::string>& texts);
  const char* const* Get() const { return this->List.empty() ? nullptr : this->List.data(); }

private:
  std::vector<const char*> List;
};

/** Keys of the library in the form of C. It has to be kept, and so have the keys. */
class KeyList
{
public:
  explicit KeyList(const std::vector<ArrayKey>& keys);
  const gatun_key* Get() const { return this->List.empty() ? nullptr : this->List.data(); }
  std::uint32_t GetCount() const { return static_cast<std::uint32_t>(this->List.size()); }

private:
  std::vector<TextList> Texts;
  std::vector<gatun_key> List;
};

/** Texts and keys of a caller. A null text is empty. */
std::vector<std::string> TakeTexts(const char* const* texts, std::uint64_t count);
std::vector<ArrayKey> TakeKeys(const gatun_key* keys, std::uint32_t count);

/** Description i of a list of arrays. */
ArrayDescription TakeArray(const gatun_array& array);
}

#endif
