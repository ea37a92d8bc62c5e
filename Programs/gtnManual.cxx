// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn --manual: the manual pages, one for gtn and one for each command, from the texts of --help.

#include "gtnAddress.h"
#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnHelp.h"
#include "gtnText.h"

#include "gatunVersion.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
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

// "gtn volume pack" as the name of its page, "gtn-volume-pack".
std::string PageOf(std::string name)
{
  for (char& c : name)
  {
    c = c == ' ' ? '-' : c;
  }
  return name;
}

std::string ReferenceTo(const std::string& name)
{
  return fmt::format(".BR {} (1)", Escaped(PageOf(name)));
}

// Title and name of a page. The summary of a name has no period.
std::string HeaderOf(const std::string& name, std::string summary)
{
  std::string title = PageOf(name);
  for (char& c : title)
  {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  while (!summary.empty() && summary.back() == '.')
  {
    summary.pop_back();
  }
  return fmt::format(".TH {} 1 \"\" \"Gatun {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n",
    Escaped(title), gatun::PackageVersion(), Escaped(PageOf(name)), Escaped(summary));
}

std::string DescribeOption(const CLI::Option& option)
{
  const std::string& text = option.get_option_text();
  return fmt::format(".TP\n.B {}{}\n{}\n", Escaped(TitleOf(option, option.get_positional())),
    text.empty() ? text : " \\fI" + Escaped(text) + "\\fR", Escaped(option.get_description()));
}

// The options of a command, each group under its name, those of all commands last.
std::string DescribeOptions(const CLI::App& command)
{
  std::string arguments;
  std::vector<std::string> groups;
  for (const CLI::Option* option : command.get_options())
  {
    const std::string& group = option->get_group();
    if (option->get_positional())
    {
      arguments += DescribeOption(*option);
    }
    else if (!group.empty() && std::find(groups.begin(), groups.end(), group) == groups.end())
    {
      groups.push_back(group);
    }
  }
  std::stable_partition(
    groups.begin(), groups.end(), [](const std::string& group) { return group != CommonGroup; });

  std::string text = arguments.empty() ? arguments : ".SH ARGUMENTS\n" + arguments;
  for (const std::string& group : groups)
  {
    text += fmt::format(".SH {}\n", Escaped(group));
    for (const CLI::Option* option : command.get_options())
    {
      if (!option->get_positional() && option->get_group() == group)
      {
        text += DescribeOption(*option);
      }
    }
  }
  return text;
}

std::string ListCommands(const CLI::App& app)
{
  std::string text;
  for (const CLI::App* command : CommandsOf(app))
  {
    text += fmt::format(".TP\n.B {}\n{}\n", command->get_name(), Escaped(SummaryOf(*command)));
  }
  return text;
}

// What ends every page.
std::string DescribeRest(const CLI::App& app, const std::string& name)
{
  std::string text =
    ".SH EXIT STATUS\n.TP\n.B 0\nSuccess.\n.TP\n.B 1\nFailure, or a file is damaged or differs. A "
    "message on stderr names the file and the reason.\n.TP\n.B 2\nThe command line is wrong.\n"
    ".SH SEE ALSO\n";
  std::vector<std::string> others;
  if (const std::size_t space = name.rfind(' '); space != name.npos)
  {
    others.push_back(ReferenceTo(name.substr(0, space)));
  }
  for (const CLI::App* command : CommandsOf(app))
  {
    others.push_back(ReferenceTo(name + " " + command->get_name()));
  }
  return text + Join(others, " ,\n") + "\n";
}

std::string DescribeProgram(const CLI::App& app)
{
  return HeaderOf("gtn", "losslessly compressed meshes, and volumes") +
    ".SH SYNOPSIS\n.B gtn\n\\fIcommand\\fR [\\fIoptions\\fR] \\fIfiles\\fR\n"
    ".SH DESCRIPTION\nA .gtn file stores a mesh or a surface with all of its arrays and "
    "time steps, bit for bit. A .ghv file stores a regular volume as Hartley coefficients. "
    "The commands are:\n" +
    ListCommands(app) + DescribeOptions(app) + ".SH FILES ON WEB SERVERS\n" + Escaped(AddressHelp) +
    "\n" + DescribeRest(app, "gtn");
}

std::string DescribeCommand(const CLI::App& command, const std::string& name)
{
  std::string synopsis = fmt::format(".B {}\n", Escaped(name));
  synopsis += CommandsOf(command).empty() ? "[\\fIoptions\\fR]"
                                          : "\\fIcommand\\fR [\\fIoptions\\fR] \\fIfiles\\fR";
  const HelpFormatter formatter;
  for (const CLI::Option* option : command.get_options())
  {
    if (option->get_positional())
    {
      synopsis += " " + Escaped(formatter.make_option_usage(option));
    }
  }

  std::string text = HeaderOf(name, SummaryOf(command)) + ".SH SYNOPSIS\n" + synopsis +
    "\n.SH DESCRIPTION\n" + Escaped(command.get_description()) + "\n" + ListCommands(command) +
    DescribeOptions(command);
  constexpr std::string_view examples = "Examples:\n";
  if (const std::string footer = command.get_footer(); footer.find(examples) == 0)
  {
    text += fmt::format(".SH EXAMPLES\n.nf\n{}\n.fi\n", Escaped(footer.substr(examples.size())));
  }
  return text + DescribeRest(command, name);
}

void WritePage(
  const std::filesystem::path& folder, const std::string& name, const std::string& text)
{
  const std::filesystem::path file = folder / (PageOf(name) + ".1");
  std::ofstream page(file);
  if (!(page << text << std::flush))
  {
    throw Failure(file.string(), "cannot be written");
  }
}

void WriteCommands(
  const CLI::App& app, const std::string& name, const std::filesystem::path& folder)
{
  for (const CLI::App* command : CommandsOf(app))
  {
    const std::string commandName = name + " " + command->get_name();
    WritePage(folder, commandName, DescribeCommand(*command, commandName));
    WriteCommands(*command, commandName, folder);
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void WriteManual(const CLI::App& app, const std::string& folder)
{
  WritePage(folder, "gtn", DescribeProgram(app));
  WriteCommands(app, "gtn", folder);
}
}
