// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunProcessExchange.h"

#include "gatunError.h"

#include "vtkMultiProcessController.h"

#include <algorithm>
#include <utility>

namespace gatun
{
namespace
{
constexpr int Tag = 27016;

// Bytes that are sent at once. MPI counts with 32 bits.
constexpr std::size_t MostAtOnce = std::size_t{ 1 } << 26;

void Require(int succeeded)
{
  if (!succeeded)
  {
    throw Error(ErrorCode::InvalidInput, "the communication between processes failed");
  }
}
}

//------------------------------------------------------------------------------
ProcessExchange::ProcessExchange(vtkMultiProcessController* controller)
  : Controller(controller)
  , Process(controller ? controller->GetLocalProcessId() : 0)
  , Processes(controller ? controller->GetNumberOfProcesses() : 1)
{
}

//------------------------------------------------------------------------------
void ProcessExchange::GatherBytes(const void* own, void* all, std::size_t bytes)
{
  if (this->Processes == 1)
  {
    return; // where the caller has put its own
  }
  Require(this->Controller->AllGather(static_cast<const unsigned char*>(own),
    static_cast<unsigned char*>(all), static_cast<vtkIdType>(bytes)));
  this->BytesSent += bytes * static_cast<std::size_t>(this->Processes - 1);
}

//------------------------------------------------------------------------------
void ProcessExchange::Broadcast(void* data, std::size_t bytes, int source)
{
  if (this->Processes == 1)
  {
    return;
  }
  auto* const first = static_cast<unsigned char*>(data);
  for (std::size_t done = 0; done < bytes; done += MostAtOnce)
  {
    const auto length = static_cast<vtkIdType>(std::min(bytes - done, MostAtOnce));
    Require(this->Controller->Broadcast(first + done, length, source));
  }
  this->BytesSent +=
    source == this->Process ? bytes * static_cast<std::size_t>(this->Processes - 1) : 0;
}

//------------------------------------------------------------------------------
std::vector<ProcessExchange::Message> ProcessExchange::Gather(const Message& own)
{
  const auto sizes = this->Gather<std::uint64_t>(own.size());
  std::vector<Message> messages(sizes.size());
  for (std::size_t p = 0; p < sizes.size(); ++p)
  {
    if (static_cast<int>(p) == this->Process)
    {
      messages[p] = own;
    }
    messages[p].resize(static_cast<std::size_t>(sizes[p]));
    this->Broadcast(messages[p].data(), messages[p].size(), static_cast<int>(p));
  }
  return messages;
}

//------------------------------------------------------------------------------
void ProcessExchange::Send(const void* data, std::size_t bytes, int process)
{
  const auto* const first = static_cast<const unsigned char*>(data);
  for (std::size_t done = 0; done < bytes; done += MostAtOnce)
  {
    const auto length = static_cast<vtkIdType>(std::min(bytes - done, MostAtOnce));
    Require(this->Controller->Send(first + done, length, process, Tag));
  }
  this->BytesSent += bytes;
}

//------------------------------------------------------------------------------
void ProcessExchange::Receive(void* data, std::size_t bytes, int process)
{
  auto* const first = static_cast<unsigned char*>(data);
  for (std::size_t done = 0; done < bytes; done += MostAtOnce)
  {
    const auto length = static_cast<vtkIdType>(std::min(bytes - done, MostAtOnce));
    Require(this->Controller->Receive(first + done, length, process, Tag));
  }
}

//------------------------------------------------------------------------------
void ProcessExchange::TalkToAll(const std::function<void(int)>& talk) const
{
  // The rounds of a tournament: in each, the numbers of two partners have the same sum modulo an
  // odd number. Of an odd number of processes, one rests.
  const int even = this->Processes + this->Processes % 2;
  const int odd = even - 1;
  for (int round = 0; round < odd; ++round)
  {
    int partner = 0;
    if (this->Process == odd)
    {
      partner = static_cast<int>(std::int64_t{ round } * (even / 2) % odd);
    }
    else
    {
      partner = (round - this->Process + odd) % odd;
      partner = partner == this->Process ? odd : partner;
    }
    if (partner < this->Processes)
    {
      talk(partner);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<ProcessExchange::Message> ProcessExchange::Exchange(std::vector<Message> messages)
{
  std::vector<Message> received(messages.size());
  // Of two partners, the one with the lower number sends first: no two wait for each other.
  const auto talk =
    [this](const void* own, std::size_t ownBytes, void* other, std::size_t otherBytes, int partner)
  {
    if (this->Process < partner)
    {
      this->Send(own, ownBytes, partner);
      this->Receive(other, otherBytes, partner);
    }
    else
    {
      this->Receive(other, otherBytes, partner);
      this->Send(own, ownBytes, partner);
    }
  };
  std::vector<std::uint64_t> sizes(messages.size());
  this->TalkToAll(
    [&](int partner)
    {
      const auto p = static_cast<std::size_t>(partner);
      const std::uint64_t size = messages[p].size();
      talk(&size, sizeof(size), &sizes[p], sizeof(size), partner);
    });
  this->Together(
    [&]
    {
      for (std::size_t p = 0; p < sizes.size(); ++p)
      {
        received[p].resize(static_cast<std::size_t>(sizes[p]));
      }
    });
  this->TalkToAll(
    [&](int partner)
    {
      const auto p = static_cast<std::size_t>(partner);
      talk(messages[p].data(), messages[p].size(), received[p].data(), received[p].size(), partner);
      messages[p] = {};
    });
  const auto self = static_cast<std::size_t>(this->Process);
  received[self] = std::move(messages[self]);
  return received;
}
}
