// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunCacheBudget.h"

#include "gatunCacheBudgetInternals.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace gatun
{
//------------------------------------------------------------------------------
class CacheBudget::Internals
{
public:
  explicit Internals(std::uint64_t bytes)
    : Bytes(bytes)
  {
  }

  mutable std::mutex Guard; // of all below, and of all maps and statistics of the users
  std::uint64_t Bytes;
  CacheStatistics Statistics;
  CacheUser::Entries Uses; // last used first
  std::vector<CacheUser*> Users;

  /** Takes out entries until so many more bytes fit, or there are none left. */
  void MakeRoom(std::uint64_t bytes, CacheUser::Entries& dropped)
  {
    const std::uint64_t most = this->Bytes - std::min(bytes, this->Bytes);
    while (this->Statistics.Bytes > most)
    {
      const auto last = std::prev(this->Uses.end());
      CacheUser& user = *last->User;
      user.Forget(last->Key);
      user.Drop(last, dropped);
    }
  }
};

//------------------------------------------------------------------------------
CacheBudget::CacheBudget(std::uint64_t bytes)
  : Self(std::make_unique<Internals>(bytes))
{
}

CacheBudget::~CacheBudget() = default;

//------------------------------------------------------------------------------
void CacheBudget::SetBytes(std::uint64_t bytes)
{
  CacheUser::Entries dropped; // destroyed without the lock
  const std::lock_guard<std::mutex> lock(this->Self->Guard);
  this->Self->Bytes = bytes;
  this->Self->MakeRoom(0, dropped);
  this->Self->Statistics.PeakBytes = this->Self->Statistics.Bytes;
  for (CacheUser* const user : this->Self->Users)
  {
    user->Statistics.PeakBytes = user->Statistics.Bytes;
  }
}

//------------------------------------------------------------------------------
std::uint64_t CacheBudget::GetBytes() const
{
  const std::lock_guard<std::mutex> lock(this->Self->Guard);
  return this->Self->Bytes;
}

//------------------------------------------------------------------------------
CacheStatistics CacheBudget::GetStatistics() const
{
  const std::lock_guard<std::mutex> lock(this->Self->Guard);
  return this->Self->Statistics;
}

//------------------------------------------------------------------------------
CacheUser::CacheUser(std::shared_ptr<CacheBudget> budget)
  : Budget(std::move(budget))
{
  const std::lock_guard<std::mutex> lock(this->GetGuard());
  this->Budget->Self->Users.push_back(this);
}

//------------------------------------------------------------------------------
CacheUser::~CacheUser()
{
  const std::lock_guard<std::mutex> lock(this->GetGuard());
  auto& users = this->Budget->Self->Users;
  users.erase(std::find(users.begin(), users.end(), this));
}

//------------------------------------------------------------------------------
std::mutex& CacheUser::GetGuard() const
{
  return this->Budget->Self->Guard;
}

//------------------------------------------------------------------------------
CacheStatistics CacheUser::GetStatistics() const
{
  const std::lock_guard<std::mutex> lock(this->GetGuard());
  return this->Statistics;
}

//------------------------------------------------------------------------------
void CacheUser::Use(Entries::iterator entry)
{
  auto& uses = this->Budget->Self->Uses;
  uses.splice(uses.begin(), uses, entry);
  ++this->Statistics.Found;
  ++this->Budget->Self->Statistics.Found;
}

//------------------------------------------------------------------------------
void CacheUser::CountMade()
{
  ++this->Statistics.Made;
  ++this->Budget->Self->Statistics.Made;
}

//------------------------------------------------------------------------------
bool CacheUser::CanFit(std::uint64_t bytes) const
{
  return bytes <= this->Budget->Self->Bytes;
}

//------------------------------------------------------------------------------
bool CacheUser::HasRoom(std::uint64_t bytes) const
{
  return this->CanFit(bytes) &&
    this->Budget->Self->Statistics.Bytes <= this->Budget->Self->Bytes - bytes;
}

//------------------------------------------------------------------------------
void CacheUser::MakeRoom(std::uint64_t bytes, Entries& dropped)
{
  this->Budget->Self->MakeRoom(bytes, dropped);
}

//------------------------------------------------------------------------------
void CacheUser::Add(Entries& added)
{
  const std::uint64_t bytes = added.front().Bytes;
  auto& uses = this->Budget->Self->Uses;
  uses.splice(uses.begin(), added);
  for (CacheStatistics* const all : { &this->Statistics, &this->Budget->Self->Statistics })
  {
    all->Bytes += bytes;
    all->PeakBytes = std::max(all->PeakBytes, all->Bytes);
    ++all->Entries;
  }
}

//------------------------------------------------------------------------------
void CacheUser::Drop(Entries::iterator entry, Entries& dropped)
{
  for (CacheStatistics* const all : { &this->Statistics, &this->Budget->Self->Statistics })
  {
    all->Bytes -= entry->Bytes;
    --all->Entries;
  }
  dropped.splice(dropped.begin(), this->Budget->Self->Uses, entry);
}
}
