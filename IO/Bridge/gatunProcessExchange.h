// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunProcessExchange_h
#define gatunProcessExchange_h

#include "gatunPartExchange.h"

#include "vtkGatunIOModule.h" // For export macro
#include "vtkType.h"          // For VTK_ABI_NAMESPACE_BEGIN

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <type_traits>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkMultiProcessController;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/**
 * What the processes of a controller tell each other. All methods except the getters are
 * collective: each process must call them in the same order. Exported for the other modules.
 *
 * Errors are shared: everything that may fail in one process runs in Together, so that no process
 * waits for one that has failed. If the controller itself fails, Error(InvalidInput) is thrown.
 */
class VTKGATUNIO_EXPORT ProcessExchange : public PartExchange
{
public:
  using PartExchange::Gather;
  using PartExchange::TakeFirst;

  /** controller: null for a process on its own. */
  explicit ProcessExchange(vtkMultiProcessController* controller);

  int GetProcess() const override { return this->Process; }
  int GetProcesses() const override { return this->Processes; }

  std::vector<Message> Gather(const Message& own) override;
  std::vector<Message> Exchange(std::vector<Message> messages) override;

  /** Returns the values of all processes. */
  template <typename T>
  std::vector<T> Gather(const T& own)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> all(static_cast<std::size_t>(this->Processes), own);
    this->GatherBytes(&own, all.data(), sizeof(T));
    return all;
  }

  /** Returns the value of the first process. */
  template <typename T>
  T TakeFirst(const T& own)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    T first = own;
    this->Broadcast(&first, sizeof(T), 0);
    return first;
  }

  /** Bytes of messages that this process has sent to others. What goes to all counts for each. */
  std::uint64_t GetBytesSent() const { return this->BytesSent; }

private:
  void GatherBytes(const void* own, void* all, std::size_t bytes);
  void Broadcast(void* data, std::size_t bytes, int source);
  void Send(const void* data, std::size_t bytes, int process);
  void Receive(void* data, std::size_t bytes, int process);

  /** Calls talk(partner) for all other processes, in an order in which each process talks to one
   * other at a time. */
  void TalkToAll(const std::function<void(int)>& talk) const;

  vtkMultiProcessController* Controller;
  int Process;
  int Processes;
  std::uint64_t BytesSent = 0;
};
}

#endif
