// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnProgress.h"

#include "gtnFailure.h"
#include "gtnScratch.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <fmt/core.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <utility>

namespace gtn
{
namespace
{

std::atomic<int> interrupted = 0; // the signal
static_assert(std::atomic<int>::is_always_lock_free);

constexpr unsigned SecondsToEnd = 3;

void EndAtOnce()
{
  RemoveScratchFiles();
  const int number = interrupted;
  std::signal(number, SIG_DFL);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, number);
  std::raise(number);
  pthread_sigmask(SIG_UNBLOCK, &only, nullptr); // of the handler itself
  _exit(1);
}

extern "C" void HandleInterrupt(int signal)
{
  if (interrupted.exchange(signal) != 0)
  {
    EndAtOnce();
  }
  alarm(SecondsToEnd);
}

extern "C" void HandleAlarm(int)
{
  EndAtOnce();
}

} // anonymous namespace

//------------------------------------------------------------------------------
void CatchInterrupts()
{
  std::signal(SIGINT, HandleInterrupt);
  std::signal(SIGTERM, HandleInterrupt);
  std::signal(SIGALRM, HandleAlarm);
}

//------------------------------------------------------------------------------
void EndInterrupted()
{
  EndAtOnce();
  _exit(1);
}

//------------------------------------------------------------------------------
bool IsInterrupted()
{
  return interrupted != 0;
}

//------------------------------------------------------------------------------
void CheckInterrupt()
{
  if (interrupted != 0)
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
  return interrupted == 0;
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
