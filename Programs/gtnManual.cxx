// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn --man: the manual page, generated from the texts of --help.

#include "gtnCommands.h"
#include "gtnHelp.h"

#include "gatunVersion.h"

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <vector>

namespace gtn
{
namespace
{

// Text without a meaning to roff.
std::string Escaped(std::string_view text)
{
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char c = text[i];
    const bool startsLine = i == 0 || text[i - 1] == '\n';
    if (startsLine && (c == '.' || c == '\''))
    {
      escaped += "\\&";
    }
    escaped += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return escaped;
}

std::vector<const CLI::App*> ChildrenOf(const CLI::App& app)
{
  return app.get_subcommands([](const CLI::App*) { return true; });
}

void PrintOption(const CLI::Option& option)
{
  const std::string& text = option.get_option_text();
  fmt::print(".TP\n.B {}{}\n{}\n", Escaped(TitleOf(option, option.get_positional())),
    text.empty() ? text : " \\fI" + Escaped(text) + "\\fR", Escaped(option.get_description()));
}

// The options of a group, or of all but that.
void PrintOptions(const CLI::App& app, const std::string& group, bool but)
{
  for (const CLI::Option* option : app.get_options())
  {
    const bool hidden = option->get_group().empty();
    if (!hidden && (option->get_group() == group) != but)
    {
      PrintOption(*option);
    }
  }
}

// "IN... OUT" of the options without dashes.
std::string Arguments(const CLI::App& app)
{
  const HelpFormatter formatter;
  std::string arguments;
  for (const CLI::Option* option : app.get_options())
  {
    if (option->get_positional())
    {
      arguments += " " + formatter.make_option_usage(option);
    }
  }
  return arguments;
}

void PrintCommand(const CLI::App& command, const std::string& parent)
{
  const std::string name = parent + " " + command.get_name();
  fmt::print(".SH {}\n", Escaped(name));
  if (ChildrenOf(command).empty())
  {
    fmt::print(".B {}\n[\\fIoptions\\fR]{}\n.PP\n", name, Escaped(Arguments(command)));
  }
  fmt::print("{}\n", Escaped(command.get_description()));
  PrintOptions(command, CommonGroup, true);
  fmt::print(".PP\n.nf\n{}\n.fi\n", Escaped(command.get_footer()));
  for (const CLI::App* child : ChildrenOf(command))
  {
    PrintCommand(*child, name);
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void PrintManual(const CLI::App& app)
{
  fmt::print(".TH GTN 1 \"\" \"Gatun {}\" \"User Commands\"\n", gatun::PackageVersion());
  fmt::print(".SH NAME\ngtn \\- losslessly compressed meshes, and volumes\n");
  fmt::print(".SH SYNOPSIS\n.B gtn\n\\fIcommand\\fR [\\fIoptions\\fR] \\fIfiles\\fR\n");
  fmt::print(
    ".SH DESCRIPTION\nA .gtn file stores a mesh or a surface with all of its arrays and "
    "time steps, bit for bit. A .ghv file stores a regular volume as Hartley coefficients. "
    "The commands are:\n");
  for (const CLI::App* command : ChildrenOf(app))
  {
    fmt::print(".TP\n.B {}\n{}\n", command->get_name(), Escaped(SummaryOf(*command)));
  }
  for (const CLI::App* command : ChildrenOf(app))
  {
    PrintCommand(*command, "gtn");
  }
  fmt::print(".SH COMMON OPTIONS\n");
  PrintOptions(*ChildrenOf(app).front(), CommonGroup, false);
  PrintOptions(app, CommonGroup, true);
  fmt::print(".SH EXIT STATUS\n.TP\n.B 0\nSuccess.\n.TP\n.B 1\nFailure, or a file is damaged or "
             "differs. A message on stderr names the file and the reason.\n.TP\n.B 2\nThe command "
             "line is wrong.\n");
}
}
