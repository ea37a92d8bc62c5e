// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnProgress.h"

#include "gtnFailure.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <utility>

namespace gtn
{
namespace
{

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void HandleInterrupt(int signal)
{
  interrupted = true;
  std::signal(signal, SIG_DFL);
}

} // anonymous namespace

//------------------------------------------------------------------------------
void CatchInterrupts()
{
  std::signal(SIGINT, HandleInterrupt);
  std::signal(SIGTERM, HandleInterrupt);
}

//------------------------------------------------------------------------------
bool IsInterrupted()
{
  return interrupted;
}

//------------------------------------------------------------------------------
void CheckInterrupt()
{
  if (interrupted)
  {
    throw Interrupted();
  }
}

//------------------------------------------------------------------------------
Progress::Progress(std::string job, bool shown)
  : Job(std::move(job))
  , Shown(shown)
  // What is done within a moment needs no bar.
  , Next(std::chrono::steady_clock::now() + std::chrono::milliseconds(300))
{
}

//------------------------------------------------------------------------------
Progress::~Progress()
{
  this->Unwatch();
  if (this->Drawn)
  {
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
  }
}

//------------------------------------------------------------------------------
bool Progress::operator()(double fraction)
{
  const auto now = std::chrono::steady_clock::now();
  if (this->Shown && now >= this->Next)
  {
    constexpr int width = 40;
    fraction = fraction > 0 ? std::min(fraction, 1.0) : 0;
    const int full = static_cast<int>(fraction * width);
    const std::string bar = fmt::format("\r\033[K{} [{:#<{}}{:.<{}}] {:3.0f} %", this->Job, "",
      full, "", width - full, fraction * 100);
    std::fputs(bar.c_str(), stderr); // the terminal may be gone; fmt::print throws then
    std::fflush(stderr);
    this->Drawn = true;
    this->Next = now + std::chrono::milliseconds(100);
  }
  return !interrupted;
}

//------------------------------------------------------------------------------
void Progress::Watch(vtkAlgorithm* algorithm, double first, double last)
{
  this->Unwatch();
  struct Call
  {
    Progress* Self;
    double First;
    double Last;
  };
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(new Call{ this, first, last });
  observer->SetClientDataDeleteCallback([](void* data) { delete static_cast<Call*>(data); });
  observer->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      const auto* call = static_cast<Call*>(data);
      auto* source = static_cast<vtkAlgorithm*>(caller);
      const double fraction = call->First + source->GetProgress() * (call->Last - call->First);
      if (!(*call->Self)(fraction))
      {
        source->SetAbortExecute(1);
      }
    });
  this->Watched = algorithm;
  this->Tag = algorithm->AddObserver(vtkCommand::ProgressEvent, observer);
}

//------------------------------------------------------------------------------
void Progress::Unwatch()
{
  if (this->Watched)
  {
    this->Watched->RemoveObserver(this->Tag);
    this->Watched = nullptr;
  }
}
}
