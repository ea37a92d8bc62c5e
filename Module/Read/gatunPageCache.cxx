// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPageCache.h"

namespace gatun
{
//------------------------------------------------------------------------------
std::shared_ptr<const void> PageCache::Find(const Key& key)
{
  const std::lock_guard lock(this->Mutex);
  const auto found = this->Pages.find(key);
  if (found == this->Pages.end())
  {
    return nullptr;
  }
  this->LastUsed.splice(this->LastUsed.begin(), this->LastUsed, found->second.Use);
  return found->second.Page;
}

//------------------------------------------------------------------------------
void PageCache::Keep(const Key& key, std::shared_ptr<const void> page, std::uint64_t bytes)
{
  const std::lock_guard lock(this->Mutex);
  const auto [place, isNew] = this->Pages.try_emplace(key);
  if (!isNew)
  {
    return;
  }
  this->LastUsed.push_front(key);
  place->second = { std::move(page), bytes, this->LastUsed.begin() };
  this->Bytes += bytes;
  while (this->Bytes > this->Budget && this->LastUsed.size() > 1)
  {
    const auto oldest = this->Pages.find(this->LastUsed.back());
    this->Bytes -= oldest->second.Bytes;
    this->Pages.erase(oldest);
    this->LastUsed.pop_back();
  }
}
}
