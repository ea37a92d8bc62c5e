// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The gtn program: options that all subcommands have, exit codes.

#include "gtnAddress.h"
#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnHelp.h"
#include "gtnMessages.h"
#include "gtnProgress.h"
#include "gtnScratch.h"
#include "gtnText.h"
#include "gtnThreads.h"

#include "gatunError.h"
#include "gatunVersion.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <unistd.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <string_view>
#include <vector>

namespace gtn
{
//------------------------------------------------------------------------------
CLI::App* AddCommand(CLI::App& app, Settings& settings, const std::string& name,
  const std::string& description, const std::string& examples, bool withThreads)
{
  CLI::App* command = app.add_subcommand(name, description);
  command->footer("Examples:\n" + examples);

  auto* quiet = command->add_flag("-q,--quiet", settings.Quiet, "Print only errors");
  auto* verbose = command->add_flag("-v,--verbose", settings.Verbose, "Print more details");
  auto* progress = command->add_flag("--progress,!--no-progress", settings.ShowProgress,
    "Show a progress bar on stderr, or hide it (default: shown if stderr is a terminal)");
  verbose->excludes(quiet);
  for (CLI::Option* option : { quiet, verbose, progress })
  {
    option->group(CommonGroup);
  }
  if (withThreads)
  {
    command
      ->add_option(
        "--threads", settings.Threads, "Number of threads, 1 to 1024 (default: one per processor)")
      ->check(CLI::Range(1, 1024))
      ->option_text("N")
      ->group(CommonGroup);
  }
  return command;
}

namespace
{

// The command line, with quotes where it takes them.
std::string JoinArguments(int argc, char* argv[])
{
  std::vector<std::string> arguments{ "gtn" };
  for (int i = 1; i < argc; ++i)
  {
    const std::string_view argument = argv[i];
    std::string quoted;
    for (const char c : argument)
    {
      quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    const bool plain =
      !argument.empty() && argument.find_first_of(" '\"\\$#*?|&;<>()[]{}~`!") == argument.npos;
    arguments.push_back(plain ? std::string(argument) : "'" + quoted + "'");
  }
  return Join(arguments, " ");
}

int Run(int argc, char* argv[])
{
  Settings settings;
  settings.CommandLine = JoinArguments(argc, argv);
  settings.ShowProgress = isatty(fileno(stderr)) != 0;
  CLI::App app{ "Compress, inspect, render, contour and simplify meshes (.gtn) and volumes (.ghv).",
    "gtn" };
  app.set_version_flag("--version",
    fmt::format("gtn {} (format {})", gatun::PackageVersion(), gatun::FormatVersion()));
  app.require_subcommand(0, 1); // none is looked at below, after unknown options
  app.formatter(std::make_shared<HelpFormatter>());
  app.footer(std::string("gtn COMMAND --help prints the options of a command and examples.\n"
                         "Exit codes: 0 success, 1 failure, 2 wrong usage.\n") +
    AddressHelp);
  app.failure_message([](const CLI::App*, const CLI::Error& error)
    { return fmt::format("gtn: {}; see gtn --help\n", error.what()); });
  // For the build, which installs what they write.
  std::string manualFolder;
  std::string shell;
  app.add_option("--manual", manualFolder, "Write the manual pages into a folder")->group("");
  app.add_option("--completion", shell, "Print the completion for a shell: bash or zsh")->group("");
  // Before anything runs, which CLI11 does when it has parsed all.
  app.parse_complete_callback(
    [&settings]
    {
      settings.ShowProgress = settings.ShowProgress && !settings.Quiet;
      SetThreads(settings.Threads);
    });
  AddPack(app, settings);
  AddUnpack(app, settings);
  AddInfo(app, settings);
  AddVerify(app, settings);
  AddMesh(app, settings);
  AddRender(app, settings);
  AddSimplify(app, settings);
  AddContour(app, settings);
  AddVolume(app, settings);

  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (!manualFolder.empty())
  {
    WriteManual(app, manualFolder);
  }
  else if (!shell.empty())
  {
    PrintCompletion(app, shell);
  }
  else if (app.get_subcommands().empty())
  {
    throw UsageError("a command is missing; see gtn --help");
  }
  return 0;
}

int Guarded(int argc, char* argv[])
{
  try
  {
    CatchMessages();
    CatchInterrupts();
    OpenAddresses();
    const int code = Run(argc, argv);
    if (std::fflush(stdout) != 0)
    {
      throw Failure("standard output", "cannot write");
    }
    return code;
  }
  catch (const UsageError& error)
  {
    Say(error.what());
    return 2;
  }
  catch (const Interrupted&)
  {
  }
  catch (const gatun::Error& error)
  {
    if (error.Code != gatun::ErrorCode::Aborted)
    {
      Say(error.what());
    }
  }
  catch (const std::exception& error)
  {
    Say(ReasonOf(error));
  }
  catch (...)
  {
    Say("failed for an unknown reason");
  }
  return 1;
}

} // anonymous namespace
}

int main(int argc, char* argv[])
{
  const int code = gtn::Guarded(argc, argv);
  gtn::ReleaseExit();
  if (gtn::IsInterrupted())
  {
    gtn::EndInterrupted(); // all is put away
  }
  return code;
}
