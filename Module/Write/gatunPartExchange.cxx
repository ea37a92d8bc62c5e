// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartExchange.h"

#include "gatunBytes.h"
#include "gatunError.h"
#include "gatunTableParts.h"
#include "gatunWriterCheck.h"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
PartExchange::~PartExchange() = default;

//------------------------------------------------------------------------------
std::vector<PartExchange::Message> PartExchange::MakeMessages() const
{
  return std::vector<Message>(static_cast<std::size_t>(this->GetProcesses()));
}

//------------------------------------------------------------------------------
void PartExchange::Together(const std::function<void()>& work)
{
  ByteWriter outcome; // empty: success
  std::exception_ptr failure;
  const auto fail = [&](ErrorCode code, const std::string& what)
  {
    failure = std::current_exception();
    outcome.Put(static_cast<std::int32_t>(code));
    outcome.PutString(what);
  };
  try
  {
    work();
  }
  catch (const Error& error)
  {
    fail(error.Code, error.what());
  }
  catch (const std::exception& error)
  {
    fail(ErrorCode::InvalidInput, error.what());
  }
  catch (...)
  {
    fail(ErrorCode::InvalidInput, "unknown error");
  }
  const auto outcomes = this->Gather(outcome.Data);
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  for (std::size_t process = 0; process < outcomes.size(); ++process)
  {
    if (!outcomes[process].empty())
    {
      ByteReader in(outcomes[process]);
      const auto code = static_cast<ErrorCode>(in.Get<std::int32_t>());
      throw Error(code, "process " + std::to_string(process) + " failed: " + in.GetString());
    }
  }
}

//------------------------------------------------------------------------------
std::vector<PartExchange::Message> PartExchange::Gather(const Message& own)
{
  auto messages = this->MakeMessages();
  std::fill(messages.begin(), messages.end(), own);
  return this->Exchange(std::move(messages));
}

//------------------------------------------------------------------------------
std::vector<PartExchange::Message> PartExchange::GatherInFirst(Message own)
{
  auto messages = this->MakeMessages();
  messages[0] = std::move(own);
  return this->Exchange(std::move(messages));
}

//------------------------------------------------------------------------------
PartExchange::Message PartExchange::TakeFirst(const Message& own)
{
  auto messages = this->MakeMessages();
  if (this->GetProcess() == 0)
  {
    std::fill(messages.begin(), messages.end(), own);
  }
  return std::move(this->Exchange(std::move(messages))[0]);
}

//------------------------------------------------------------------------------
bool PartExchange::IsAny(bool own)
{
  const auto all = this->Gather({ static_cast<std::uint8_t>(own) });
  return std::any_of(all.begin(), all.end(), [](const Message& other) { return other[0] != 0; });
}

//------------------------------------------------------------------------------
std::optional<std::vector<ArrayDescription>> PartExchange::TakeArrays(
  const std::optional<std::vector<ArrayDescription>>& own)
{
  ByteWriter out; // empty: no mesh
  this->Together(
    [&]
    {
      if (own)
      {
        CheckArrays(*own);
        PutArrays(out, *own);
      }
    });
  for (const auto& message : this->Gather(out.Data))
  {
    if (!message.empty())
    {
      ByteReader in(message);
      return GetArrays(in);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void PartExchange::ExchangeInRounds(const std::function<bool(std::vector<Message>&)>& fill,
  const std::function<void(const Message&)>& take)
{
  for (bool hasMore = true; hasMore;)
  {
    auto messages = this->MakeMessages();
    this->Together([&] { hasMore = fill(messages); });
    const auto received = this->Exchange(std::move(messages));
    this->Together([&] { std::for_each(received.begin(), received.end(), take); });
    hasMore = this->IsAny(hasMore);
  }
}
}
