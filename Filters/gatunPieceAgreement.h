// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPieceAgreement_h
#define gatunPieceAgreement_h

#include "vtkType.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <exception>
#include <utility>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkMultiProcessController;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** Keeps processes together that do the same, so that none waits for one that has failed. All
 * processes must call the same functions. */
class PieceAgreement
{
public:
  /** controller: null for a process on its own. */
  explicit PieceAgreement(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  vtkMultiProcessController* GetController() const { return this->Controller; }

  /** Whether something holds in all processes. */
  bool AreAll(bool holds);

  /** Calls an action. Throws in all processes if it throws in one: what it threw where it did, and
   * Error(InvalidInput) in the others. */
  template <typename Action>
  void Do(Action&& action)
  {
    std::exception_ptr failure;
    try
    {
      std::forward<Action>(action)();
    }
    catch (...)
    {
      failure = std::current_exception();
    }
    this->Check(failure);
  }

private:
  void Check(const std::exception_ptr& failure);

  vtkMultiProcessController* const Controller;
};
}

#endif
