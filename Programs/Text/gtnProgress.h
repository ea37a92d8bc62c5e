// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnProgress_h
#define gtnProgress_h

// A bar on the terminal, and Ctrl+C.

#include "vtkCommand.h"
#include "vtkSmartPointer.h"

#include <chrono>
#include <string>

class vtkAlgorithm;

namespace gtn
{
/** Lets Ctrl+C and SIGTERM end what runs in good order. What does not end within some seconds, such
 * as a reader of VTK, or a second Ctrl+C, ends the program at once; of files that it writes,
 * nothing is left. */
void CatchInterrupts();

/** Whether Ctrl+C was pressed, or SIGTERM came. */
bool IsInterrupted();

/** Ends the program as the signal ends others. */
[[noreturn]] void EndInterrupted();

/** Throws Interrupted if Ctrl+C was pressed. */
void CheckInterrupt();

/** A job on the progress bar; the bar goes away with it. */
class Progress
{
public:
  Progress(std::string job, bool shown);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /** Shows a fraction of 0 to 1; false to stop. Fits the callbacks of the core. */
  bool operator()(double fraction);

  /** Shows the progress of a VTK algorithm and lets Ctrl+C abort it, until this object goes. The
   * algorithm makes up the part of the job from first to last. */
  void Watch(vtkAlgorithm* algorithm, double first = 0, double last = 1);

private:
  void Unwatch();

  std::string Job;
  bool Shown;
  bool Drawn = false;
  std::chrono::steady_clock::time_point Next;
  vtkSmartPointer<vtkAlgorithm> Watched;
  unsigned long Tag = 0;
};
}

#endif
