// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunControllerExchange_h
#define gatunControllerExchange_h

#include "gatunPartExchange.h"
#include "gatunProcessExchange.h"

#include <utility>
#include <vector>

namespace gatun
{
/** The messages of the processes of a controller that write a file together. */
class ControllerExchange : public PartExchange
{
public:
  explicit ControllerExchange(vtkMultiProcessController* controller)
    : Processes(controller)
  {
  }

  int GetProcess() const override { return this->Processes.GetProcess(); }
  int GetProcesses() const override { return this->Processes.GetProcesses(); }
  std::vector<Message> Exchange(std::vector<Message> messages) override
  {
    return this->Processes.Exchange(std::move(messages));
  }

private:
  ProcessExchange Processes;
};
}

#endif
