// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnMessages.h"

#include "gtnFailure.h"
#include "gtnReadable.h"
#include "gtnText.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <cstdio>
#include <mutex>
#include <set>
#include <utility>

namespace gtn
{
namespace
{

struct Messages
{
  std::mutex Lock;
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};

Messages& TheMessages()
{
  static Messages messages;
  return messages;
}

// "ERROR: In file, line 1\nvtkClass (0x123): text\n\n" becomes "text".
std::string Text(const char* message)
{
  std::string_view text = message ? message : "";
  const std::size_t preamble = text.find("): ");
  if (preamble != text.npos && (text.starts_with("ERROR: In ") || text.starts_with("Warning: In ")))
  {
    text.remove_prefix(preamble + 3);
  }
  while (!text.empty() && (text.back() == '\n' || text.back() == '.' || text.back() == ' '))
  {
    text.remove_suffix(1);
  }
  return MakePrintableLine(text);
}

class MessageKeeper : public vtkOutputWindow
{
public:
  static MessageKeeper* New();
  vtkTypeMacro(MessageKeeper, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override { Keep(TheMessages().Errors, text); }
  void DisplayWarningText(const char* text) override { Keep(TheMessages().Warnings, text); }
  void DisplayGenericWarningText(const char* text) override { Keep(TheMessages().Warnings, text); }

private:
  static void Keep(std::vector<std::string>& list, const char* text)
  {
    const std::lock_guard guard(TheMessages().Lock);
    constexpr std::size_t enough = 100; // a damaged file may cause one for every value
    if (list.size() < enough)
    {
      // All that the pipeline knows is that something failed.
      std::string line = Text(text);
      list.push_back(line.starts_with("Algorithm vtk") ? "failed" : std::move(line));
    }
  }
};
vtkStandardNewMacro(MessageKeeper);

std::vector<std::string> Take(std::vector<std::string>& list)
{
  const std::lock_guard guard(TheMessages().Lock);
  return std::exchange(list, {});
}

} // anonymous namespace

//------------------------------------------------------------------------------
void CatchMessages()
{
  TheMessages(); // must outlive the window
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<MessageKeeper> keeper;
  vtkOutputWindow::SetInstance(keeper);
}

//------------------------------------------------------------------------------
std::vector<std::string> TakeErrors()
{
  return Take(TheMessages().Errors);
}

//------------------------------------------------------------------------------
std::vector<std::string> TakeWarnings()
{
  return Take(TheMessages().Warnings);
}

//------------------------------------------------------------------------------
void CheckMessages(const std::string& file, bool quiet)
{
  const std::vector<std::string> warnings = TakeWarnings();
  const std::vector<std::string> errors = TakeErrors();
  if (!errors.empty())
  {
    // The first one is the cause, the others are what came of it.
    throw Failure(file, ExplainRefusal(file, errors.front()));
  }
  for (const std::string& warning : warnings)
  {
    SayOnce(file, warning, quiet);
  }
}

//------------------------------------------------------------------------------
void SayOnce(const std::string& file, const std::string& warning, bool quiet)
{
  // The same may be said at every time step.
  static std::set<std::string> said;
  const std::string message = Failure(file, warning).what();
  if (!quiet && said.insert(message).second)
  {
    Say(message);
  }
}

//------------------------------------------------------------------------------
void Say(std::string_view message) noexcept
{
  // Not by fmt::print, which may throw and may need memory.
  std::fflush(stdout);
  std::fputs("gtn: ", stderr);
  std::fwrite(message.data(), 1, message.size(), stderr);
  std::fputc('\n', stderr);
}
}
