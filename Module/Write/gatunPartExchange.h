// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartExchange_h
#define gatunPartExchange_h

#include "gatunExport.h" // For export macro
#include "gatunTypes.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace gatun
{
/**
 * Messages between processes that write a file together; see PartWriter.
 *
 * All methods except the getters are collective: each process must call them in the same order. All
 * processes must have the same byte order and data types.
 */
class GATUN_EXPORT PartExchange
{
public:
  using Message = std::vector<std::uint8_t>;

  PartExchange() = default;
  virtual ~PartExchange();
  PartExchange(const PartExchange&) = delete;
  PartExchange& operator=(const PartExchange&) = delete;

  virtual int GetProcess() const = 0;
  virtual int GetProcesses() const = 0;

  /** Sends a message to each process, and returns the messages from each. May throw in all
   * processes. */
  virtual std::vector<Message> Exchange(std::vector<Message> messages) = 0;

  /** Runs work, which must not be collective. If it throws in a process, all processes throw: that
   * one the same exception, the others an Error with its code and message. */
  void Together(const std::function<void()>& work);

  /** Returns the messages of all processes. Together and IsAny call it. */
  virtual std::vector<Message> Gather(const Message& own);

  /** Returns the messages of all processes in the first one, and empty ones in the others. */
  std::vector<Message> GatherInFirst(Message own);

  /** Returns the message of the first process. */
  Message TakeFirst(const Message& own);

  /** Whether the argument is true in any process. */
  bool IsAny(bool own);

  /** Returns the arrays of the first process that has a mesh, or nothing if none has. own: the
   * arrays of this process, or nothing if it has no mesh. */
  std::optional<std::vector<ArrayDescription>> TakeArrays(
    const std::optional<std::vector<ArrayDescription>>& own);

  /** Exchanges any amount of data in rounds. fill adds to the messages and returns whether there is
   * more; take gets each message. Errors of both are thrown in all processes. */
  void ExchangeInRounds(const std::function<bool(std::vector<Message>&)>& fill,
    const std::function<void(const Message&)>& take);

private:
  std::vector<Message> MakeMessages() const;
};
}

#endif
